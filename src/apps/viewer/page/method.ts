import type { App } from "./app";
import { button, find, select } from "./dom";
import type { Integrator, Parameter, State } from "./protocol";

/// Chosen by clicks and the brush, not by the name of a file.
const kNotHere = ["regions"];

/// The method and its parameters. Each change is sent at once, and is one that can be undone.
export class Method {
  private shown = "";
  private readonly fields = find("method-fields");
  private readonly select = select([], "Method of rendering", (name) => this.send(name, {}));

  constructor(private readonly app: App) {
    this.select.id = "integrator";
    this.select.setAttribute("aria-label", "Method");
    find("method-select").append(this.select, button("Defaults", "All parameters as they are by default", () => this.send(this.select.value, {})));
    app.welcomed.on(() => this.list());
    app.stated.on((state) => this.take(state));
  }

  private list(): void {
    const integrators = this.app.integrators();
    find("panel-method").hidden = integrators.length === 0;
    this.select.replaceChildren(...integrators.map(({ name, summary }) => ajar.element("option", { value: name, title: summary }, name)));
    this.shown = "";
    if (this.app.state) this.take(this.app.state);
  }

  private take({ integrator, parameters }: State): void {
    const known = this.app.integrators().find((one) => one.name === integrator);
    const key = JSON.stringify([integrator, parameters]);
    if (!known || key === this.shown) return;
    // Not over what a person is typing.
    if (this.fields.contains(document.activeElement) && document.activeElement?.matches("input:focus")) {
      if (this.shown && JSON.parse(this.shown)[0] === integrator) return;
    }
    this.shown = key;
    this.select.value = integrator;
    this.show(known, parameters);
  }

  private send(integrator: string, parameters: Record<string, string>): void {
    this.app.changes.send({ type: "method", integrator, parameters });
  }

  private show(integrator: Integrator, parameters: Record<string, string>): void {
    find("method-summary").replaceChildren(integrator.summary, ...(integrator.source ? [ajar.element("span", { class: "quiet" }, ` ${integrator.source}`)] : []));
    const usual: HTMLElement[] = [];
    const expert: HTMLElement[] = [];
    for (const parameter of integrator.parameters) {
      if (kNotHere.includes(parameter.name) || !matters(parameter, integrator, parameters)) continue;
      (parameter.expert ? expert : usual).push(this.field(parameter, integrator, parameters));
    }
    const wasOpen = this.fields.querySelector("details")?.open ?? false;
    this.fields.replaceChildren(...usual, ...(expert.length > 0 ? [ajar.element("details", { open: wasOpen, class: "expert" }, ajar.element("summary", {}, `For experts (${expert.length})`), ...expert)] : []));
  }

  private field(parameter: Parameter, integrator: Integrator, parameters: Record<string, string>): HTMLElement {
    const { name, unit, help, minimum, maximum } = parameter;
    const given = parameters[name];
    const change = (text: string) => {
      const others = { ...parameters };
      delete others[name];
      const isUsual = text === "" || text === parameter.default;
      this.send(integrator.name, isUsual ? others : { ...others, [name]: text });
    };
    const range = minimum !== undefined || maximum !== undefined ? ` (${parameter.choices ? `${parameter.choices.join(", ")} or ` : ""}${minimum ?? "…"} to ${maximum ?? "…"})` : "";
    const id = `parameter-${name}`;
    const control = controlFor(parameter, given, change);
    control.id = id;
    return ajar.element("div", { class: given === undefined ? "field" : "field changed" },
      ajar.element("label", { class: "field-name", for: id, title: `${help}${range}; default: ${parameter.default || "none"}` }, name),
      control,
      ...(unit ? [ajar.element("span", { class: "unit" }, unit)] : []),
      ajar.element("p", { class: "help", title: help }, `${help}${range}${given === undefined ? "" : `; default: ${parameter.default || "none"}`}`));
  }
}

function matters({ depends_on, matters_for }: Parameter, integrator: Integrator, parameters: Record<string, string>): boolean {
  if (!depends_on || !matters_for) return true;
  const other = integrator.parameters.find((one) => one.name === depends_on);
  return matters_for.includes(parameters[depends_on] ?? other?.default ?? "");
}

function controlFor(parameter: Parameter, given: string | undefined, change: (text: string) => void): HTMLInputElement | HTMLSelectElement {
  const { type, choices, minimum, maximum } = parameter;
  const value = given ?? parameter.default;
  const isNumber = type === "float" || type === "int";
  // Choices of other types are words beside what can be written.
  const options = type === "bool" ? ["true", "false"] : type === "choice" ? choices : undefined;
  if (options) {
    const control = select(options.map((one) => [one, one] as const), parameter.help, change);
    control.value = value;
    return control;
  }
  const isPlain = isNumber && !choices;
  const input = ajar.element("input", {
    type: isPlain && (value === "" || Number.isFinite(Number(value))) ? "number" : "text",
    step: type === "int" ? 1 : "any",
    min: isPlain ? minimum : undefined,
    max: isPlain ? maximum : undefined,
    value,
    placeholder: parameter.default,
    spellcheck: "false",
    onchange: () => {
      if (input.reportValidity()) change(input.value.trim());
    },
  });
  return input;
}
