// Drawing interface of figures: the part of a canvas context that they use, so that the same code also makes an SVG.

/// Style of a pen, stored by `save`.
const STYLE = [
  'fillStyle',
  'strokeStyle',
  'lineWidth',
  'globalAlpha',
  'font',
  'textAlign',
  'textBaseline',
  'lineJoin',
  'lineCap',
] as const;

export type Pen = Pick<
  CanvasRenderingContext2D,
  | (typeof STYLE)[number]
  | 'beginPath'
  | 'moveTo'
  | 'lineTo'
  | 'arc'
  | 'rect'
  | 'closePath'
  | 'stroke'
  | 'fill'
  | 'fillText'
  | 'setLineDash'
  | 'save'
  | 'restore'
  | 'clip'
  | 'translate'
  | 'rotate'
  | 'drawImage'
>;

export const FONT = 'system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

export function font(size: number, weight = 400): string {
  return `${weight} ${size}px ${FONT}`;
}

let ruler: CanvasRenderingContext2D | null = null;

/// Returns the width of a text in pixels.
export function textWidth(text: string, face: string): number {
  ruler ??= document.createElement('canvas').getContext('2d')!;
  ruler.font = face;
  return ruler.measureText(text).width;
}

const BASELINE: Record<string, string> = { middle: '0.35em', top: '0.8em', bottom: '-0.2em' };
const ANCHOR: Record<string, string> = { center: 'middle', right: 'end', end: 'end' };

export function escaped(text: string): string {
  return text.replace(/[&<>"']/g, (letter) => `&#${letter.charCodeAt(0)};`);
}

function short(value: number): string {
  return String(Math.round(value * 100) / 100);
}

/// A pen that writes the text of an SVG.
export class SvgPen implements Pen {
  fillStyle: string | CanvasGradient | CanvasPattern = '#000';
  strokeStyle: string | CanvasGradient | CanvasPattern = '#000';
  lineWidth = 1;
  globalAlpha = 1;
  font = font(12);
  textAlign: CanvasTextAlign = 'left';
  textBaseline: CanvasTextBaseline = 'alphabetic';
  lineJoin: CanvasLineJoin = 'miter';
  lineCap: CanvasLineCap = 'butt';
  private dash: readonly number[] = [];
  /// Number of groups opened since the state was saved.
  private groups = 0;
  private readonly stack: Record<string, unknown>[] = [];
  private readonly parts: string[] = [];
  private path: string[] = [];
  private clips = 0;

  constructor(
    private readonly width: number,
    private readonly height: number,
    private readonly title: string,
  ) {}

  beginPath(): void {
    this.path = [];
  }

  moveTo(x: number, y: number): void {
    this.path.push(`M${short(x)} ${short(y)}`);
  }

  lineTo(x: number, y: number): void {
    this.path.push(`${this.path.length ? 'L' : 'M'}${short(x)} ${short(y)}`);
  }

  closePath(): void {
    this.path.push('Z');
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.path.push(`M${short(x)} ${short(y)}h${short(width)}v${short(height)}h${short(-width)}Z`);
  }

  arc(x: number, y: number, radius: number, from: number, to: number, counterclockwise = false): void {
    const at = (angle: number) => `${short(x + radius * Math.cos(angle))} ${short(y + radius * Math.sin(angle))}`;
    const r = short(radius);
    const full = Math.abs(to - from) >= 2 * Math.PI - 1e-6;
    const turn = counterclockwise ? 0 : 1;
    const begin = `${this.path.length ? 'L' : 'M'}${at(from)}`;
    if (full) {
      const half = from + (turn ? Math.PI : -Math.PI);
      this.path.push(`M${at(from)}A${r} ${r} 0 1 ${turn} ${at(half)}A${r} ${r} 0 1 ${turn} ${at(from)}`);
      return;
    }
    const sweep = (((turn ? to - from : from - to) % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
    this.path.push(`${begin}A${r} ${r} 0 ${sweep > Math.PI ? 1 : 0} ${turn} ${at(to)}`);
  }

  stroke(): void {
    const dash = this.dash.length ? ` stroke-dasharray="${this.dash.join(' ')}"` : '';
    this.put(
      `<path d="${this.path.join('')}" fill="none" stroke="${this.colour(this.strokeStyle)}" ` +
        `stroke-width="${short(this.lineWidth)}"` +
        ` stroke-linejoin="${this.lineJoin}" stroke-linecap="${this.lineCap}"${dash}${this.opacity()}/>`,
    );
  }

  fill(): void {
    this.put(`<path d="${this.path.join('')}" fill="${this.colour(this.fillStyle)}"${this.opacity()}/>`);
  }

  fillText(text: string, x: number, y: number): void {
    const [, weight = '400', size = '12', family = FONT] = /^(?:(\d+) )?([\d.]+)px (.*)$/.exec(this.font) ?? [];
    const anchor = ANCHOR[this.textAlign] ?? 'start';
    const shift = BASELINE[this.textBaseline] ?? '0';
    this.put(
      `<text x="${short(x)}" y="${short(y)}" dy="${shift}" text-anchor="${anchor}" font-family="${escaped(family)}"` +
        ` font-size="${size}" font-weight="${weight}" ` +
        `fill="${this.colour(this.fillStyle)}"${this.opacity()}>${escaped(text)}</text>`,
    );
  }

  drawImage(image: CanvasImageSource, x: number, y: number, width?: number, height?: number): void {
    if (!(image instanceof HTMLCanvasElement)) return;
    this.put(
      `<image x="${short(x)}" y="${short(y)}" width="${short(width ?? image.width)}" ` +
        `height="${short(height ?? image.height)}"` +
        ` preserveAspectRatio="none" href="${image.toDataURL('image/png')}"/>`,
    );
  }

  setLineDash(dash: Iterable<number>): void {
    this.dash = [...dash];
  }

  save(): void {
    const style = STYLE.map((name) => [name, this[name]]);
    this.stack.push({ ...Object.fromEntries(style), dash: this.dash, groups: this.groups });
    this.groups = 0;
  }

  restore(): void {
    for (; this.groups > 0; this.groups--) this.put('</g>');
    const state = this.stack.pop();
    if (state) Object.assign(this, state);
  }

  clip(): void {
    const name = `clip${++this.clips}`;
    this.put(`<clipPath id="${name}"><path d="${this.path.join('')}"/></clipPath>`);
    this.open(`clip-path="url(#${name})"`);
  }

  translate(x: number, y: number): void {
    this.open(`transform="translate(${short(x)} ${short(y)})"`);
  }

  rotate(angle: number): void {
    this.open(`transform="rotate(${short((angle * 180) / Math.PI)})"`);
  }

  /// The whole file.
  text(): string {
    while (this.stack.length || this.groups) this.restore();
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" width="${this.width}" height="${this.height}"` +
      ` viewBox="0 0 ${this.width} ${this.height}" ` +
      `role="img"><title>${escaped(this.title)}</title>\n${this.parts.join('\n')}\n</svg>\n`
    );
  }

  private put(part: string): void {
    this.parts.push(part);
  }

  private open(attributes: string): void {
    this.put(`<g ${attributes}>`);
    this.groups++;
  }

  private colour(style: string | CanvasGradient | CanvasPattern): string {
    return typeof style === 'string' ? escaped(style) : '#000';
  }

  private opacity(): string {
    return this.globalAlpha < 1 ? ` opacity="${short(this.globalAlpha)}"` : '';
  }
}

/// Converts an SVG to a PNG of at least twice its size and at least 1200 pixels wide.
export async function pngOf(svg: string, width: number, height: number): Promise<Blob> {
  const address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement('canvas');
    const finer = Math.max(2, 1200 / width);
    canvas.width = Math.round(finer * width);
    canvas.height = Math.round(finer * height);
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) =>
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the picture could not be made'))), 'image/png'),
    );
  } finally {
    URL.revokeObjectURL(address);
  }
}
