// Elements of the page. Text goes in as text nodes and attributes alone: nothing that a case file holds is ever markup.

type Attributes = Readonly<Record<string, string | number | boolean>>;

function decorate(element: Element, attributes: Attributes, children: readonly (Node | string)[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false) continue;
    element.setAttribute(name, value === true ? '' : String(value));
  }
  element.append(...children);
}

export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  decorate(element, attributes, children);
  return element;
}

/// A button with a text and what it does. Its name is what is seen, so that who speaks to the page can say it; a sign
/// alone has the label for its name.
export function button(
  text: string,
  label: string,
  action: () => void,
  attributes: Attributes = {},
): HTMLButtonElement {
  const spoken = /[a-z]/i.test(text) && !label.toLowerCase().includes(text.trim().toLowerCase());
  const made = el('button', { type: 'button', 'aria-label': !spoken && label, title: label, ...attributes }, text);
  made.addEventListener('click', action);
  return made;
}

export interface Choice {
  readonly value: string;
  readonly text: string;
}

/// A drop-down list; `chosen` is told the value.
export function select(
  label: string,
  choices: readonly Choice[],
  value: string,
  chosen: (value: string) => void,
): HTMLSelectElement {
  const made = el('select', { 'aria-label': label, title: label });
  setChoices(made, choices, value);
  made.addEventListener('change', () => chosen(made.value));
  return made;
}

export function setChoices(list: HTMLSelectElement, choices: readonly Choice[], value: string): void {
  list.replaceChildren(...choices.map((choice) => el('option', { value: choice.value }, choice.text)));
  list.value = value;
}

/// A row of buttons of which one is pressed.
export class Segments {
  readonly root: HTMLElement;
  private readonly buttons: readonly HTMLButtonElement[];

  constructor(
    label: string,
    choices: readonly (Choice & { readonly title?: string })[],
    value: string,
    chosen: (value: string) => void,
  ) {
    this.buttons = choices.map((choice) => {
      const made = el(
        'button',
        { type: 'button', value: choice.value, title: choice.title ?? choice.text },
        choice.text,
      );
      made.addEventListener('click', () => {
        this.value = choice.value;
        chosen(choice.value);
      });
      return made;
    });
    this.root = el('div', { class: 'segments', role: 'group', 'aria-label': label }, ...this.buttons);
    this.value = value;
  }

  /// Another text on a button.
  rename(value: string, text: string): void {
    const found = this.buttons.find((made) => made.value === value);
    if (found) found.textContent = text;
  }

  set value(value: string) {
    for (const made of this.buttons) made.setAttribute('aria-pressed', String(made.value === value));
  }
}

/// Hands a file to the reader.
export function download(name: string, type: string, content: BlobPart): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = el('a', { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/// Copies to the clipboard; where the browser does not allow it (a page from disk may be refused), false.
export async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = el('textarea', { 'aria-hidden': 'true', class: 'offscreen' });
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    return done;
  }
}

/// The field that the reader is at, and whether it has changed since its value was last taken.
let touched: { readonly field: EventTarget | null; typing: boolean } | undefined;
document.addEventListener('input', ({ target }) => (touched = { field: target, typing: true }), true);
document.addEventListener('change', ({ target }) => touched?.field === target && (touched.typing = false), true);
document.addEventListener('focusout', () => (touched = undefined), true);

/// Whether what stands in a field is the reader's: it keeps the focus since it was changed.
export function isTouched(field: HTMLElement): boolean {
  return touched?.field === field;
}

/// Whether the reader is in the middle of a change of a field.
export function isTyping(): boolean {
  return touched?.typing ?? false;
}

/// What stands in fields is the page's again.
export function releaseFields(): void {
  touched = undefined;
}
