const { element } = ajar;

/// The element of index.html with this id.
export function find<Type extends HTMLElement = HTMLElement>(id: string): Type {
  const found = document.getElementById(id);
  if (!found) throw new Error(`index.html has no ${id}`);
  return found as Type;
}

export function button(text: string, title: string, action: () => void, attributes: ajar.Attributes = {}): HTMLButtonElement {
  return element("button", { type: "button", title, onclick: action, ...attributes }, text);
}

/// A control with its name before it.
export function labelled(name: string, control: HTMLElement, title = "", unit = ""): HTMLLabelElement {
  const after = unit ? [element("span", { class: "unit" }, unit)] : [];
  return element("label", { class: "field", title: title || undefined }, element("span", { class: "field-name" }, name), control, ...after);
}

export function select(options: readonly (readonly [string, string])[], title: string, action: (value: string) => void): HTMLSelectElement {
  const control = element("select", { title, onchange: () => action(control.value) },
    ...options.map(([value, text]) => element("option", { value }, text)));
  return control;
}

/// `action` has the number, or null where the input was emptied.
export function numberInput(attributes: ajar.Attributes, action: (value: number | null) => void): HTMLInputElement {
  const input = element("input", {
    type: "number",
    step: "any",
    ...attributes,
    onchange: () => {
      if (input.reportValidity()) action(input.value === "" ? null : input.valueAsNumber);
    },
  });
  return input;
}

/// Shows a value, but not over what a person is typing.
export function showValue(control: HTMLInputElement | HTMLSelectElement, value: string): void {
  if (document.activeElement !== control && control.value !== value) control.value = value;
}

/// Numbers as inputs hold them: a float of the server is short again.
export const plain = (value: number, digits = 7): string => String(Number(value.toPrecision(digits)));

/// Counts as they are, other numbers with 4 digits.
export const shortOf = (value: number): string =>
  Number.isInteger(value) && Math.abs(value) < 1e6 ? String(value) : ajar.format(value);
