import type { App } from "./app";
import { find, numberInput, plain, select } from "./dom";
import type { Part, PartKind, PartValue } from "./protocol";

const kKinds: readonly PartKind[] = ["materials", "lights"];

/// Numbers and colours of materials and lights.
export class Edits {
  private kind: PartKind = "materials";
  private index = 0;
  private readonly kindSelect = select(kKinds.map((kind) => [kind, kind] as const), "Materials or lights", (kind) => this.choose(kind as PartKind, 0));
  private readonly partSelect = select([], "The one that is edited", (index) => this.choose(this.kind, Number(index)));
  private readonly fields = find("edit-fields");

  constructor(private readonly app: App) {
    this.kindSelect.setAttribute("aria-label", "Kind");
    this.partSelect.setAttribute("aria-label", "Name");
    this.partSelect.id = "edit-part";
    find("edit-select").append(this.kindSelect, this.partSelect);
    app.welcomed.on(() => this.choose(this.kind, this.index));
  }

  /// The material of this name, where there is one.
  showMaterial(name: string): void {
    const index = this.parts("materials").findIndex((part) => part.name === name);
    if (index >= 0 && name) this.choose("materials", index);
  }

  private parts(kind: PartKind): Part[] {
    return this.app.welcome?.parts?.[kind] ?? [];
  }

  private choose(kind: PartKind, index: number): void {
    this.kind = kind;
    const parts = this.parts(kind);
    this.index = index < parts.length ? index : 0;
    this.kindSelect.value = kind;
    this.partSelect.replaceChildren(...parts.map((part, i) =>
      ajar.element("option", { value: i }, part.name || `${part.model ?? "none"} ${i + 1}`)));
    this.partSelect.value = String(this.index);
    this.partSelect.disabled = parts.length === 0;
    this.show();
  }

  private show(): void {
    const part = this.parts(this.kind)[this.index];
    if (!part) {
      this.fields.replaceChildren(ajar.element("p", { class: "quiet" }, `The scene has no ${this.kind} to edit. Shapes that glow are not among them.`));
      return;
    }
    const rows = Object.entries(part.parameters ?? {}).flatMap(([name, value]) => {
      const control = this.control(part, name, value);
      return control ? [ajar.element("div", { class: "field" }, ajar.element("span", { class: "field-name" }, name), control)] : [];
    });
    this.fields.replaceChildren(ajar.element("p", { class: "quiet" }, part.model ?? ""), ...rows);
  }

  private control(part: Part, name: string, value: PartValue): HTMLElement | null {
    const set = (next: PartValue) => this.set(part, name, next);
    if (typeof value === "boolean") {
      const box = ajar.element("input", { type: "checkbox", checked: value, "aria-label": name, onchange: () => set(box.checked) });
      return box;
    }
    if (typeof value === "number") {
      return numberInput({ value: plain(value), "aria-label": name }, (next) => (next === null ? this.show() : set(next)));
    }
    if (Array.isArray(value) && value.length === 3) return this.colour(name, value, set);
    if (value !== null && typeof value === "object") return ajar.element("span", { class: "quiet" }, "texture" in value ? `texture ${String(value.texture)}` : "material");
    if (typeof value === "string" && value) return ajar.element("span", { class: "quiet" }, value);
    return null;
  }

  /// Three numbers, and a swatch that opens the browser's chooser. Colours above white keep their size.
  private colour(name: string, value: number[], set: (value: PartValue) => void): HTMLElement {
    const inputs = value.map((number, i) =>
      numberInput({ value: plain(number), min: 0, "aria-label": `${name}, ${["red", "green", "blue"][i]}` }, (next) => {
        if (next !== null) set(value.map((old, other) => (other === i ? next : old)));
      }));
    const scale = Math.max(1, ...value);
    const swatch = ajar.element("input", {
      type: "color", value: hexOf(value.map((x) => x / scale)), "aria-label": `${name}, chooser`,
      onchange: () => set(linearOf(swatch.value).map((x) => Number((x * scale).toPrecision(4)))),
    });
    return ajar.element("span", { class: "colour" }, swatch, ...inputs);
  }

  private set(part: Part, name: string, next: PartValue): void {
    const { kind, index } = this;
    const before = part.parameters?.[name] ?? null;
    const hold = (value: PartValue) => () => {
      if (part.parameters) part.parameters[name] = value;
      this.show();
    };
    hold(next)();
    this.app.changes.send({ type: "edit", kind, index, parameters: { [name]: next } }, { undo: hold(before), redo: hold(next) });
  }
}

function hexOf(linear: number[]): string {
  return `#${linear.map((x) => Math.round(255 * ajar.srgbFromLinear(ajar.clamp(x, 0, 1))).toString(16).padStart(2, "0")).join("")}`;
}

function linearOf(hex: string): number[] {
  return [1, 3, 5].map((at) => {
    const x = parseInt(hex.slice(at, at + 2), 16) / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  });
}
