import type { App } from "./app";
import { find, shortOf } from "./dom";
import type { State } from "./protocol";

const kPhases: Record<State["phase"], string> = {
  loading: "Loading",
  preparing: "Preparing",
  rendering: "Rendering",
  paused: "Paused",
  finished: "Finished",
  failed: "Failed",
};

function rate(perSecond: number): string {
  for (const [size, unit] of [[1e9, "G"], [1e6, "M"], [1e3, "k"]] as const) {
    if (perSecond >= size) return `${ajar.format(perSecond / size, 3)} ${unit}`;
  }
  return ajar.format(perSecond, 3);
}

function duration(seconds: number): string {
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  const whole = Math.floor(seconds);
  const two = (n: number) => String(n).padStart(2, "0");
  const minutes = `${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
  return whole < 3600 ? minutes : `${Math.floor(whole / 3600)}:${minutes}`;
}

/// The line under the picture, the panel of chains, the page's title, and what is said of a missing connection.
export class Status {
  private isOpen = false;

  constructor(app: App) {
    app.stated.on((state) => this.show(state));
    app.welcomed.on(({ scene, version }) => {
      const name = scene.split("/").filter(Boolean).slice(-2).join("/");
      document.title = `${name} – Ajar`;
      find("title").textContent = name;
      find("title").title = scene;
      find("version").textContent = version;
    });
    app.socket.connection.on(({ isOpen, reason }) => {
      this.isOpen = isOpen;
      find("offline").hidden = isOpen;
      find("offline-reason").textContent = reason;
      document.body.classList.toggle("is-offline", !isOpen);
      if (!isOpen) find("phase").textContent = "Not connected";
    });
  }

  private show(state: State): void {
    if (!this.isOpen) return;
    const phase = find("phase");
    phase.textContent = kPhases[state.phase] ?? state.phase;
    phase.dataset.phase = state.phase;
    find("failure").hidden = state.phase !== "failed";
    find("failure").textContent = state.message;
    const facts: [string, string, string][] = [
      ["samples", `${shortOf(state.samples)} spp`, "Samples per pixel"],
      ["time", duration(state.seconds), "Time of rendering"],
      ["error", this.error(state), "Estimated relative error of the picture"],
    ];
    if (state.rays_per_second) facts.push(["rays", `${rate(state.rays_per_second)} rays/s`, "Rays per second"]);
    if (state.mutations_per_second) facts.push(["mutations", `${rate(state.mutations_per_second)} mutations/s`, "Mutations of the chains per second"]);
    find("facts").replaceChildren(...facts.map(([key, text, title]) => ajar.element("span", { title, "data-fact": key }, text)));
    const progress = find<HTMLProgressElement>("progress");
    progress.hidden = state.done === null || state.done === undefined;
    progress.value = state.done ?? 0;
    this.showChains(state);
  }

  /// A bound says so: rare light that has not been met is missing in the estimate.
  private error({ error, error_is_lower_bound }: State): string {
    if (error === null || error === undefined) return "error –";
    return `error ${error_is_lower_bound ? "≥" : "≈"} ${ajar.format(100 * error, 3)} %`;
  }

  private showChains({ chain_share, acceptance }: State): void {
    const list = acceptance ?? [];
    find("panel-chains").hidden = list.length === 0 && (chain_share ?? null) === null;
    const facts: [string, number][] = [...(typeof chain_share === "number" ? [["share of the time", chain_share] as [string, number]] : []),
      ...list.map(({ move, acceptance: share }) => [move, share] as [string, number])];
    find("chains").replaceChildren(...facts.flatMap(([name, share]) => [
      ajar.element("dt", {}, name),
      ajar.element("dd", {}, ajar.element("meter", { value: share, min: 0, max: 1, "aria-label": name }), ` ${(100 * share).toFixed(0)} %`),
    ]));
  }
}
