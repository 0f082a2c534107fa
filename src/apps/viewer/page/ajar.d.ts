/// The report's scripts that the page shares (study/report/page: base.js, half.js, colour.js, shader.js).
declare namespace ajar {
  type Attributes = Record<string, string | number | boolean | undefined | ((event: any) => void)>;
  type Colour = readonly [number, number, number];

  function element<Name extends keyof HTMLElementTagNameMap>(
    name: Name,
    attributes?: Attributes,
    ...children: (Node | string | undefined)[]
  ): HTMLElementTagNameMap[Name];
  function clamp(value: number, low: number, high: number): number;
  function format(value: number, digits?: number): string;
  function perFrame(action: () => void): () => void;

  function srgbFromLinear(x: number): number;
  const halfs: Float32Array;
  const maps: { ember: Colour[]; zones: Colour[]; zoneStops: number };
  const tones: Record<string, { title: string; apply: ((x: number) => number) | null }>;
  const notFinite: Colour;

  const shaderTones: string[];
  const shaderParts: string;
  function makeProgram(gl: WebGL2RenderingContext, fragmentSource: string): WebGLProgram;
  function makeMapTexture(gl: WebGL2RenderingContext): WebGLTexture;
  function setNearest(gl: WebGL2RenderingContext): void;
}
