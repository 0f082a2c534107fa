import type { App } from "./app";
import { button, find } from "./dom";
import type { Inspector } from "./inspector";
import type { Pixel, Rule, State } from "./protocol";
import type { Tools } from "./tools";

type Kind = Rule["kind"];
const kKinds: readonly Kind[] = ["object", "material"];
const kChoices = ["auto", "chain", "omc"] as const;
const kTitles: Record<string, string> = {
  auto: "The method decides",
  chain: "Markov chains",
  omc: "Ordinary Monte Carlo",
};

/// The division of the picture: rules for objects and materials, set by clicks.
export class Regions {
  private rules: Rule[] = [];
  private selected: Pixel | null = null;
  private readonly ownRows = find("region-selected");
  private readonly list = find("region-rules");

  constructor(private readonly app: App, tools: Tools, private readonly inspector: Inspector, private readonly showMaterial: (name: string) => void) {
    tools.add({
      name: "regions",
      title: "Regions",
      key: "r",
      help: "Click: that object by the method, by chains, by ordinary Monte Carlo. Shift + click: its material",
      click: (point, event) => void this.click(point, event.shiftKey ? "material" : "object"),
    });
    app.stated.on((state) => this.take(state));
    this.showSelected();
    this.showRules();
  }

  private async click(point: { x: number; y: number }, kind: Kind): Promise<void> {
    const pixel = await this.inspector.ask(point);
    const name = pixel?.[kind]?.name;
    if (pixel) this.selected = pixel;
    this.showMaterial(pixel?.material?.name ?? "");
    if (!name) {
      this.app.tell(pixel?.[kind] ? `That ${kind} has no name, which a rule needs.` : `There is no ${kind} here.`);
      this.showSelected();
      return;
    }
    const at = kChoices.findIndex((choice) => choice === this.choiceOf(kind, name));
    this.choose(kind, name, kChoices[(at + 1) % kChoices.length] ?? "auto");
  }

  private take({ rules }: State): void {
    if (JSON.stringify(rules) === JSON.stringify(this.rules)) return;
    // Not while a person moves a weight.
    if (document.activeElement?.matches(".rule input:active")) return;
    this.rules = rules;
    this.showSelected();
    this.showRules();
  }

  private choiceOf(kind: Kind, name: string): string | number {
    return this.rules.findLast((rule) => rule.kind === kind && rule.name === name)?.choice ?? "auto";
  }

  /// The last rule that matches holds, so a new one comes last.
  private choose(kind: Kind, name: string, choice: string | number): void {
    const others = this.rules.filter((rule) => rule.kind !== kind || rule.name !== name);
    this.send(choice === "auto" ? others : [...others, { kind, name, choice }]);
  }

  private send(rules: Rule[]): void {
    // The server writes weights as text.
    const asNumbers = rules.map((rule) => ({ ...rule, choice: Number.isFinite(Number(rule.choice)) ? Number(rule.choice) : rule.choice }));
    this.rules = rules;
    this.app.changes.send({ type: "regions", rules: asNumbers });
    this.showSelected();
    this.showRules();
  }

  private showSelected(): void {
    const rows = kKinds.flatMap((kind) => {
      const name = this.selected?.[kind]?.name;
      return name ? [this.row(kind, name)] : [];
    });
    const hint = "With the regions tool (r), click an object in the picture: it goes to Markov chains. Shift + click takes its material.";
    this.ownRows.replaceChildren(...(rows.length > 0 ? rows : [ajar.element("p", { class: "quiet" }, hint)]));
  }

  private row(kind: Kind, name: string): HTMLElement {
    const choice = this.choiceOf(kind, name);
    const weight = Number(choice);
    const buttons = kChoices.map((one) =>
      button(one, kTitles[one] ?? "", () => this.choose(kind, name, one), { "aria-pressed": String(one === choice) }));
    return ajar.element("div", { class: "rule", "data-kind": kind },
      ajar.element("span", { class: "rule-name", title: name }, ajar.element("span", { class: "quiet" }, `${kind} `), name),
      ajar.element("div", { class: "rule-row" },
        ajar.element("div", { class: "group" }, ...buttons),
        ...this.slider(kind, name, Number.isFinite(weight) ? weight : choice === "chain" ? 1 : choice === "omc" ? 0 : 0.5)));
  }

  private slider(kind: Kind, name: string, weight: number): HTMLElement[] {
    const shown = ajar.element("output", {}, weight.toFixed(2));
    const slider = ajar.element("input", {
      type: "range", min: 0, max: 1, step: 0.05, value: weight,
      title: "Share of chains", "aria-label": `Share of chains for the ${kind} ${name}`,
      oninput: () => (shown.textContent = slider.valueAsNumber.toFixed(2)),
      onchange: () => this.choose(kind, name, slider.valueAsNumber),
    });
    return [slider, shown];
  }

  private showRules(): void {
    const rows = this.rules.map((rule, at) => ajar.element("li", {},
      ajar.element("span", { class: "rule-name", title: `${rule.kind} ${rule.name}` }, ajar.element("span", { class: "quiet" }, `${rule.kind} `), rule.name),
      ajar.element("span", { class: `tag choice-${rule.choice}` }, String(rule.choice)),
      button("✕", "Remove this rule", () => this.send(this.rules.filter((_, other) => other !== at)), { class: "small", "aria-label": `Remove the rule for the ${rule.kind} ${rule.name}` })));
    const all = button("Remove all", "Remove all rules", () => this.send([]), { class: "small", disabled: this.rules.length === 0 });
    this.list.replaceChildren(...(rows.length > 0 ? [...rows, ajar.element("li", { class: "end" }, all)] : [ajar.element("li", { class: "quiet" }, "No rules: the method decides everywhere.")]));
  }
}
