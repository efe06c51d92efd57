// Elements of the page. Text is inserted only as text nodes and attributes, so that texts of a case file are never
// markup.

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

/// Makes a button. Its accessible name is its visible text, which speech control uses; a button with only a sign has
/// the name `label`.
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

/// Makes a drop-down list; `chosen` is called with the selected value.
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

  /// Changes the text of a button.
  rename(value: string, text: string): void {
    const found = this.buttons.find((made) => made.value === value);
    if (found) found.textContent = text;
  }

  /// Shows the button with a text, or hides it.
  offer(value: string, text: string | undefined): void {
    const found = this.buttons.find((made) => made.value === value);
    if (!found) return;
    found.hidden = text === undefined;
    if (text !== undefined) found.textContent = found.title = text;
  }

  set value(value: string) {
    for (const made of this.buttons) made.setAttribute('aria-pressed', String(made.value === value));
  }
}

/// Downloads a file.
export function download(name: string, type: string, content: BlobPart): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = el('a', { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/// Copies to the clipboard; returns false if the browser refuses (as for some pages opened from disk).
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

/// The field that the user is editing, and whether it has changed since its value was last read.
let touched: { readonly field: EventTarget | null; typing: boolean } | undefined;
document.addEventListener('input', ({ target }) => (touched = { field: target, typing: true }), true);
document.addEventListener('change', ({ target }) => touched?.field === target && (touched.typing = false), true);
document.addEventListener('focusout', () => (touched = undefined), true);

/// Returns true if the user has changed a field and it still has the focus: the page must not overwrite it.
export function isTouched(field: HTMLElement): boolean {
  return touched?.field === field;
}

/// Returns true while the user is changing a field.
export function isTyping(): boolean {
  return touched?.typing ?? false;
}

/// Lets the page overwrite all fields again.
export function releaseFields(): void {
  touched = undefined;
}
