import type { App } from "./app";
import { kChannels, kMaps, type ChannelName, type MapName } from "./display";
import { button, find, labelled, select } from "./dom";
import type { Stage } from "./stage";

/// Exposure, tone curve, layer and channel: the row over the picture, and the scale of false colours.
export class Layers {
  private names: string[] = [""];
  private readonly layer = select([["", "Picture"]], "Layer (l)", (name) => this.app.showLayer(name));
  private readonly map = select(Object.entries(kMaps), "How values become colours", (name) => this.setMap(name as MapName));
  private readonly tone = select(
    ajar.shaderTones.map((name) => [name, ajar.tones[name]?.title ?? name] as const),
    "Tone curve (t)",
    (tone) => this.app.display.set({ tone }),
  );
  private readonly channel = select(Object.entries(kChannels), "Channel", (channel) =>
    this.app.display.set({ channel: channel as ChannelName }));
  private readonly exposure = ajar.element("input", {
    type: "range", id: "exposure", min: -10, max: 10, step: 0.1, value: 0, title: "Exposure in stops (e, Shift+e); double click: 0",
    oninput: () => this.app.display.set({ exposure: this.exposure.valueAsNumber }),
    ondblclick: () => this.app.display.set({ exposure: 0 }),
  });
  private readonly shownExposure = ajar.element("output", { id: "shown-exposure", for: "exposure" });
  private readonly shownZoom = ajar.element("output", { id: "shown-zoom", title: "Screen pixels per image pixel" });

  constructor(private readonly app: App, private readonly stage: Stage) {
    this.layer.id = "layer";
    this.map.id = "map";
    const { view } = app;
    find("view-tools").append(
      labelled("Layer", this.layer),
      labelled("As", this.map),
      labelled("Exposure", this.exposure),
      this.shownExposure,
      labelled("Tone", this.tone),
      labelled("Channel", this.channel),
    );
    find("zoom-tools").append(
      button("Fit", "Whole picture (f)", () => view.fit()),
      button("1:1", "One screen pixel per image pixel (1)", () => view.toPixels()),
      this.shownZoom);
    app.stated.on(({ layers }) => this.list(layers));
    app.welcomed.on(() => this.list(app.state?.layers ?? [""], true));
    app.framed.on(() => this.show());
    app.layerChanged.on(() => this.show());
    app.display.changed.on(() => this.show());
    view.changed.on(() => this.showZoom());
    this.show();
  }

  step(by: number): void {
    const { names } = this;
    const next = (names.indexOf(this.app.layer) + by + names.length) % names.length;
    this.app.showLayer(names[next] ?? "");
  }

  nextTone(): void {
    const tones = ajar.shaderTones;
    this.app.display.set({ tone: tones[(tones.indexOf(this.app.display.tone) + 1) % tones.length] ?? "srgb" });
  }

  private setMap(map: MapName): void {
    this.app.display.setMap(this.app.frame?.layer ?? this.app.layer, map);
  }

  private list(names: string[], isForced = false): void {
    if (names.length === 0 || (!isForced && names.join("\n") === this.names.join("\n"))) return;
    this.names = names;
    const help = new Map(this.app.welcome?.layers.map((one) => [one.name, one.help]));
    // The layer that is asked for stays on the list while a new render has none yet.
    const listed = names.includes(this.app.layer) ? names : [...names, this.app.layer];
    this.layer.replaceChildren(...listed.map((name) =>
      ajar.element("option", { value: name, title: help.get(name) }, name || "Picture")));
    this.show();
  }

  private show(): void {
    const { app } = this;
    const { display, frame } = app;
    const channels = frame?.channels ?? 3;
    const shown = frame?.layer ?? app.layer;
    const map = display.mapOf(shown, channels);
    this.layer.value = app.layer;
    this.map.value = map;
    this.tone.value = display.tone;
    this.channel.value = display.channel;
    this.exposure.value = String(display.exposure);
    const { exposure } = display;
    this.shownExposure.textContent = `${exposure > 0 ? "+" : exposure < 0 ? "−" : ""}${Math.abs(exposure).toFixed(1)}`;
    for (const control of [this.exposure, this.tone]) control.disabled = map !== "colour";
    this.channel.disabled = channels === 1;
    this.showHelp(shown);
    this.showLegend(map);
  }

  private showHelp(shown: string): void {
    const label = find("layer-help");
    const help = this.app.welcome?.layers.find((one) => one.name === this.app.layer)?.help ?? "";
    const isMissing = shown !== this.app.layer && this.app.frame !== null;
    label.hidden = this.app.layer === "" && !isMissing;
    label.replaceChildren(ajar.element("strong", {}, this.app.layer || "Picture"), isMissing ? " is not there yet" : help && `: ${help}`);
  }

  private showZoom(): void {
    const { zoom } = this.app.view.place();
    this.shownZoom.textContent = `${Math.round(100 * zoom)} %`;
  }

  private showLegend(map: MapName): void {
    const legend = find("legend");
    const isZones = map === "colour" && this.app.display.tone === "zones";
    legend.hidden = !isZones && map !== "heat" && map !== "decades";
    if (legend.hidden) return;
    const { ember, zones, zoneStops } = ajar.maps;
    const [low, high] = this.stage.range;
    const texts = isZones
      ? [`−${zoneStops}`, "0", `+${zoneStops} stops from middle grey`]
      : [ajar.format(low, 3), ajar.format(map === "heat" ? (low + high) / 2 : Math.sqrt(Math.max(low, 1e-12) * Math.max(high, 1e-12)), 3), ajar.format(high, 3)];
    const colours = isZones ? zones : ember.filter((_, i) => i % 15 === 0);
    const bar = ajar.element("div", { class: "legend-bar" });
    // Elements' own styles are set through the object: the page's policy forbids the attribute.
    bar.style.background = `linear-gradient(90deg, ${colours.map((rgb) => `rgb(${rgb.map((x) => Math.round(255 * x)).join(" ")})`).join(", ")})`;
    legend.replaceChildren(bar, ajar.element("div", { class: "legend-ticks" }, ...texts.map((text) => ajar.element("span", {}, text))));
  }
}
