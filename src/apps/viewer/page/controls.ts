import type { App } from "./app";
import { button, find, labelled, numberInput, plain, showValue } from "./dom";
import type { State, StopAt } from "./protocol";

const kStops = [
  ["samples", "Samples", "per pixel"],
  ["seconds", "Time", "s"],
  ["error", "Error", "relative"],
] as const;

/// Pause, end, undo, save and resolution.
export class Controls {
  private readonly pauseButton = button("Pause", "Pause or go on (space)", () => this.togglePause(), { id: "pause" });
  private readonly undoButton = button("Undo", "Undo (z)", () => this.app.changes.undo(), { id: "undo", disabled: true });
  private readonly redoButton = button("Redo", "Redo (Shift+z)", () => this.app.changes.redo(), { id: "redo", disabled: true });
  private readonly stops = new Map<keyof StopAt, HTMLInputElement>();
  private readonly width = numberInput({ min: 1, max: 8192, step: 1, "aria-label": "width" }, () => this.sendSize());
  private readonly height = numberInput({ min: 1, max: 8192, step: 1, "aria-label": "height" }, () => this.sendSize());

  constructor(private readonly app: App) {
    find("render-tools").append(
      ajar.element("div", { class: "group" },
        this.pauseButton,
        button("Restart", "Begin this picture anew", () => app.socket.send({ type: "restart" }), { id: "restart" })),
      ajar.element("div", { class: "group" }, this.undoButton, this.redoButton),
      ajar.element("div", { class: "group" },
        button("Save EXR", "Save all layers (s)", () => this.save("exr"), { id: "save-exr" }),
        button("PNG", "Save what can be looked at (Shift+s)", () => this.save("png"), { id: "save-png" })),
    );
    for (const [name, title, unit] of kStops) {
      const input = numberInput({ min: 0, placeholder: "none", id: `stop-${name}` }, () => this.sendStops());
      this.stops.set(name, input);
      find("stop-at").append(labelled(title, input, `The render ends at this; empty: it does not`, unit));
    }
    this.width.id = "width";
    this.height.id = "height";
    find("resolution").append(ajar.element("div", { class: "field" }, ajar.element("span", { class: "field-name" }, "Resolution"),
      ajar.element("span", { class: "pair" }, this.width, "×", this.height)));
    app.stated.on((state) => this.take(state));
    app.saved.on(({ path, error }) => (path ? app.tell(`Saved as ${path}`) : app.tell(`Not saved: ${error ?? "no reason given"}`, "warning")));
    app.welcomed.on(() => {
      for (const id of ["panel-regions", "panel-camera", "panel-edits", "stop-at", "resolution", "crop"]) find(id).hidden = app.isFixed();
      this.pauseButton.parentElement!.hidden = app.isFixed();
      this.undoButton.parentElement!.hidden = app.isFixed();
    });
  }

  togglePause(): void {
    this.app.socket.send({ type: this.isHalted() ? "resume" : "pause" });
  }

  save(format: "exr" | "png"): void {
    const { exposure, tone } = this.app.display;
    this.app.socket.send({ type: "save", format, exposure, tone });
  }

  private isHalted(): boolean {
    return this.app.state?.phase === "paused";
  }

  private sendStops(): void {
    const value = (name: keyof StopAt) => {
      const number = this.stops.get(name)?.valueAsNumber ?? NaN;
      return Number.isFinite(number) && number > 0 ? number : null;
    };
    this.app.socket.send({ type: "stop-at", samples: value("samples"), seconds: value("seconds"), error: value("error") });
  }

  private sendSize(): void {
    const [width, height] = [this.width.valueAsNumber, this.height.valueAsNumber];
    const { state } = this.app;
    if (!(width >= 1 && height >= 1) || (state?.width === width && state.height === height)) return;
    this.app.changes.send({ type: "resolution", width, height });
  }

  private take(state: State): void {
    this.pauseButton.textContent = this.isHalted() ? "Resume" : "Pause";
    this.pauseButton.setAttribute("aria-pressed", String(this.isHalted()));
    this.undoButton.disabled = !state.can_undo;
    this.redoButton.disabled = !state.can_redo;
    for (const [name, input] of this.stops) {
      const value = state.stop_at?.[name];
      showValue(input, value === null || value === undefined ? "" : plain(value));
    }
    // One of the two may be new while the other is being typed.
    if (document.activeElement !== this.width && document.activeElement !== this.height) {
      showValue(this.width, String(state.width));
      showValue(this.height, String(state.height));
    }
  }
}
