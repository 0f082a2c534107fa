import type { Window } from "./protocol";

/// A decoded frame: a rectangle of the picture in half floats, scene-linear.
export interface Frame {
  number: number;
  epoch: number;
  /// of the full image
  imageWidth: number;
  imageHeight: number;
  /// of the rectangle, in pixels of the image
  x: number;
  y: number;
  width: number;
  height: number;
  /// A pixel of the frame stands for step × step pixels of the image.
  step: number;
  channels: 1 | 3;
  layer: string;
  columns: number;
  rows: number;
  /// A view of the message, not a copy.
  halfs: Uint16Array;
}

const kMagic = 0x31464a41; // AJF1
const kHeader = 28;

/// Raises an Error if the message is no frame.
export function decodeFrame(message: ArrayBuffer): Frame {
  if (message.byteLength < kHeader) throw new Error("a frame is too short");
  const view = new DataView(message);
  if (view.getUint32(0, true) !== kMagic) throw new Error("a message is no frame");
  const [imageWidth, imageHeight, x, y, width, height, step] = [12, 14, 16, 18, 20, 22, 24].map((at) =>
    view.getUint16(at, true),
  ) as [number, number, number, number, number, number, number];
  const channels = view.getUint8(26);
  if ((channels !== 1 && channels !== 3) || step === 0) throw new Error("a frame has a wrong header");
  const nameLength = view.getUint8(27);
  const start = kHeader + 4 * Math.ceil(nameLength / 4);
  const columns = Math.ceil(width / step);
  const rows = Math.ceil(height / step);
  const count = channels * columns * rows;
  if (message.byteLength !== start + 2 * count) throw new Error("a frame has a wrong length");
  return {
    number: view.getUint32(4, true),
    epoch: view.getUint32(8, true),
    imageWidth,
    imageHeight,
    x,
    y,
    width,
    height,
    step,
    channels,
    layer: new TextDecoder().decode(new Uint8Array(message, kHeader, nameLength)),
    columns,
    rows,
    halfs: new Uint16Array(message, start, count),
  };
}

/// Values of a pixel of the image, or undefined where the frame has none.
export function valuesAt(frame: Frame, x: number, y: number): number[] | undefined {
  const column = Math.floor((x - frame.x) / frame.step);
  const row = Math.floor((y - frame.y) / frame.step);
  if (x < frame.x || y < frame.y || column >= frame.columns || row >= frame.rows) return undefined;
  const first = frame.channels * (row * frame.columns + column);
  return Array.from(frame.halfs.subarray(first, first + frame.channels), (bits) => ajar.halfs[bits] ?? NaN);
}

/// The range in which 98 % of the frame's finite values are, from a sample of them.
export function rangeOf(frame: Frame): [number, number] {
  const { halfs } = frame;
  const values: number[] = [];
  const stride = Math.max(1, Math.floor(halfs.length / 12000));
  for (let i = 0; i < halfs.length; i += stride) {
    const value = ajar.halfs[halfs[i] ?? 0] ?? NaN;
    if (Number.isFinite(value)) values.push(value);
  }
  if (values.length === 0) return [0, 1];
  values.sort((a, b) => a - b);
  const at = (share: number) => values[Math.floor(share * (values.length - 1))] ?? 0;
  const [low, high] = [at(0.01), at(0.99)];
  return high > low ? [low, high] : [low, low + Math.max(Math.abs(low), 1e-3)];
}

/// A mask for the server: a byte per pixel, row by row; null takes it away.
export function encodeMask(width: number, height: number, weights: Uint8Array | null): ArrayBuffer {
  const size = weights ? width * height : 0;
  const message = new ArrayBuffer(12 + size);
  const view = new DataView(message);
  view.setUint32(0, 0x314d4a41, true); // AJM1
  if (weights) {
    view.setUint32(4, width, true);
    view.setUint32(8, height, true);
    new Uint8Array(message, 12).set(weights);
  }
  return message;
}

/// The whole of an image.
export const wholeWindow = (width: number, height: number): Window => [0, 0, width, height];
