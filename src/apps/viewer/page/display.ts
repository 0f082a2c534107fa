import { Signal } from "./signal";

/// How values become colours: by the tone curve, by a scale of even or of logarithmic steps, or a colour for each number.
export const kMaps = { colour: "Tone curve", heat: "Heat", decades: "Heat, log", labels: "Labels" } as const;
export type MapName = keyof typeof kMaps;

export const kChannels = { all: "All", red: "Red", green: "Green", blue: "Blue", luminance: "Luminance" } as const;
export type ChannelName = keyof typeof kChannels;

const kLargestExposure = 20;

/// How pictures are shown. The map is kept for each layer: a scale fits depth, not colours.
export class Display {
  exposure = 0;
  tone = "srgb";
  channel: ChannelName = "all";
  readonly changed = new Signal();
  private readonly maps = new Map<string, MapName>();

  set(change: { exposure?: number; tone?: string; channel?: ChannelName }): void {
    Object.assign(this, change);
    this.exposure = ajar.clamp(Math.round(10 * this.exposure) / 10, -kLargestExposure, kLargestExposure);
    this.changed.emit();
  }

  mapOf(layer: string, channels: 1 | 3): MapName {
    return this.maps.get(layer) ?? usualMap(layer, channels);
  }

  setMap(layer: string, map: MapName): void {
    this.maps.set(layer, map);
    this.changed.emit();
  }
}

function usualMap(layer: string, channels: 1 | 3): MapName {
  if (/-id(\.|$)/.test(layer) || layer === "regions") return "labels";
  if (/^(standard-error|noise|density)/.test(layer)) return "decades";
  return channels === 1 ? "heat" : "colour";
}
