// Messages of docs/develop/live-viewer.md.

export type Vector = [number, number, number];

export interface Parameter {
  name: string;
  type: string;
  default: string;
  unit: string;
  expert: boolean;
  help: string;
  minimum?: number;
  maximum?: number;
  choices?: string[];
  depends_on?: string;
  matters_for?: string[];
}

export interface Integrator {
  name: string;
  summary: string;
  source: string;
  parameters: Parameter[];
}

export type PartValue = null | boolean | number | string | number[] | Record<string, unknown>;

export interface Part {
  name: string;
  model?: string;
  parameters?: Record<string, PartValue>;
}

export type PartKind = "materials" | "lights";

export interface Welcome {
  type: "welcome";
  scene: string;
  version: string;
  integrators: Integrator[] | { integrators: Integrator[] };
  layers: { name: string; help: string }[];
  objects: string[];
  materials: string[];
  parts: Partial<Record<PartKind, Part[]>>;
}

export interface Rule {
  kind: "object" | "material";
  name: string;
  /// chain, omc, or a weight, which the server writes as text
  choice: string | number;
}

export interface CameraPose {
  position: Vector;
  target: Vector;
  up: Vector;
  /// degrees, of the shorter side
  fov: number;
  lens_radius: number;
  focal_distance: number;
}

export interface StopAt {
  samples: number | null;
  seconds: number | null;
  error: number | null;
}

export type Window = [number, number, number, number];

export interface State {
  type: "state";
  phase: "loading" | "preparing" | "rendering" | "paused" | "finished" | "failed";
  message: string;
  epoch: number;
  width: number;
  height: number;
  crop: Window | null;
  samples: number;
  seconds: number;
  rays_per_second: number | null;
  mutations_per_second: number | null;
  error: number | null;
  error_is_lower_bound: boolean;
  layers: string[];
  integrator: string;
  parameters: Record<string, string>;
  rules: Rule[];
  masked: boolean;
  camera: CameraPose;
  stop_at: StopAt;
  can_undo: boolean;
  can_redo: boolean;
  done: number | null;
  chain_share: number | null;
  acceptance: { move: string; acceptance: number }[];
}

export interface History {
  type: "history";
  points: [number, number][];
}

export interface Pixel {
  type: "pixel";
  x: number;
  y: number;
  values: Record<string, number[]>;
  object: { number: number; name: string } | null;
  material: { number: number; name: string } | null;
  region: number | null;
  samples: number | null;
  error: number | null;
}

export interface Note {
  type: "note";
  level: "note" | "warning";
  text: string;
}

export interface Saved {
  type: "saved";
  path?: string;
  error?: string;
}

export type FromServer = Welcome | State | History | Pixel | Note | Saved;

export type ToServer =
  | { type: "hello"; token: string; version: 1 }
  | { type: "ack"; frame: number }
  | { type: "layer"; name: string }
  | { type: "inspect"; x: number; y: number }
  | { type: "pause" | "resume" | "restart" | "undo" | "redo" }
  | ({ type: "stop-at" } & StopAt)
  | { type: "method"; integrator: string; parameters: Record<string, string> }
  | { type: "regions"; rules: Rule[] }
  | ({ type: "camera"; moving: boolean } & CameraPose)
  | { type: "resolution"; width: number; height: number }
  | { type: "crop"; window: Window | null }
  | { type: "edit"; kind: PartKind; index: number; parameters: Record<string, PartValue> }
  | { type: "save"; format: "exr" | "png"; exposure: number; tone: string };
