// Writes quantities for units.sh, one a line ("TEXT|EXPECTED UNIT"):  node units.mjs < NAMES
//
// They are every name of the database with every prefix, and random products, powers and misspelt units from a fixed
// seed. The database's logarithmic units, which cases do not accept, and powers beyond those of physics are left out.
import { readFileSync } from 'node:fs';

let seed = 1;
/// Draws a whole number below `count` (generator of Park and Miller 1988).
function draw(count) {
  seed = (seed * 48271) % 2147483647;
  return seed % count;
}
const pick = (list) => list[draw(list.length)];

const names = [];
const prefixes = [];
let inPrefixes = false;
for (const line of readFileSync(0, 'utf8').split('\n')) {
  const [, tag, text] = /^<(\w+)[^>]*>(.*)<$/.exec(line) ?? [];
  if (tag === 'value') inPrefixes = true;
  else if (tag)
    (inPrefixes ? prefixes : names).push(
      text.replace(/&#x([0-9A-Fa-f]+);/g, (_, code) => String.fromCodePoint(parseInt(code, 16))).trim(),
    );
}
const linear = [...new Set(names)].filter((name) => !/^B(Z|z|W|m|V|v|µV)$|^bel/i.test(name) || name === 'bm');
// prettier-ignore
const kinds = [
  '', 'm', 'kg', 's', 'rad/s', 'N', 'N/m', 'N s/m', 'Pa s', '1', 'rad', 'Pa', 'm/s2', '1/s', 'kg m', 'W', 'J', 'm2/s',
  'K',
];
const lines = [];
for (const name of linear) {
  const forms = [
    name,
    `${name}s`,
    `${name}es`,
    name.toUpperCase(),
    name.replaceAll(' ', '_'),
    `${name}2`,
    `${name}-1`,
    `1/${name}`,
  ];
  for (const form of forms) lines.push(`2.5 ${form}|`);
  for (const kind of kinds) lines.push(`2.5 ${name}|${kind}`);
  for (const prefix of prefixes) lines.push(`3 ${prefix}${name}|`);
}

const everyday = (
  'm mm um µm in mil ft kg g t N kN mN lbf lb s ms min h rpm rps rad deg Hz Pa kPa MPa bar mPa cP W kW J K ' +
  'degC °C % A V mol cd L l'
).split(' ');
const joints = ['.', '.', ' ', ' ', '*', '/', '/', '·', ' / ', ' * ', ' . ', '-', ' per ', '  ', ' PER '];
// prettier-ignore
const powers = [
  '', '', '', '', '2', '-1', '^2', '^-1', '**2', '²', '³', '⁻¹', '3', '-2', '0', '1', '^0', '-', '^', '2.', '⁻',
];
const factor = () => pick(everyday) + pick(powers);
for (let i = 0; i < 20000; i++) {
  let text = '';
  for (let n = 1 + draw(4); n > 0; n--) {
    const inner = draw(10) === 0 ? `(${factor()}${pick(joints)}${factor()})${pick(powers)}` : factor();
    text += inner + (n > 1 ? pick(joints) : '');
  }
  lines.push(`${pick(['1', '0.3', '-7e3'])} ${text}|${pick(kinds)}`);
}
const signs = [...'mkgNsrad/. ^2-*()1%µ²·_'];
for (let i = 0; i < 20000; i++)
  lines.push(`1 ${Array.from({ length: 1 + draw(8) }, () => pick(signs)).join('')}|${pick(kinds.slice(0, 4))}`);
process.stdout.write([...new Set(lines)].join('\n') + '\n');
