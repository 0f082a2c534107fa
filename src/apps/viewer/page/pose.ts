import type { CameraPose, Vector } from "./protocol";

// Movements of a camera. Each gives a new pose.

const add = (a: Vector, b: Vector, scale = 1): Vector => [a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]];
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a: Vector): number => Math.sqrt(dot(a, a));
const normalized = (a: Vector): Vector => {
  const size = length(a) || 1;
  return [a[0] / size, a[1] / size, a[2] / size];
};

/// Rodrigues' rotation about a unit axis.
function rotated(v: Vector, axis: Vector, angle: number): Vector {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return add(add([v[0] * c, v[1] * c, v[2] * c], cross(axis, v), s), axis, dot(axis, v) * (1 - c));
}

/// Nearest angle between the view and the upward axis.
const kPole = 0.03;

/// Turns about the target: `right` and `down` in radians, as the mouse moves.
export function orbited(pose: CameraPose, right: number, down: number): CameraPose {
  const up = normalized(pose.up);
  let offset = rotated(add(pose.position, pose.target, -1), up, -right);
  const polar = Math.acos(ajar.clamp(dot(normalized(offset), up), -1, 1));
  const side = normalized(cross(up, offset));
  const change = ajar.clamp(polar - down, kPole, Math.PI - kPole) - polar;
  offset = rotated(offset, side, change);
  return { ...pose, position: add(pose.target, offset) };
}

/// Moves camera and target by shares of their distance.
export function walked(pose: CameraPose, ahead: number, right: number, up: number): CameraPose {
  const view = add(pose.target, pose.position, -1);
  const distance = length(view);
  const forward = normalized(view);
  const upward = normalized(pose.up);
  const side = normalized(cross(forward, upward));
  let step: Vector = [0, 0, 0];
  for (const [axis, share] of [[forward, ahead], [side, right], [upward, up]] as const) step = add(step, axis, share * distance);
  return { ...pose, position: add(pose.position, step), target: add(pose.target, step) };
}

/// Moves towards the target, or away from it: the distance is multiplied.
export function dollied(pose: CameraPose, factor: number): CameraPose {
  const offset = add(pose.position, pose.target, -1);
  return { ...pose, position: add(pose.target, offset, factor) };
}

/// With the target at another distance in the same direction: the picture stays.
export function reaching(pose: CameraPose, distance: number): CameraPose {
  const forward = normalized(add(pose.target, pose.position, -1));
  return { ...pose, target: add(pose.position, forward, distance) };
}

/// The focal distance, along the axis, of a point that a pixel's ray meets after `depth`.
export function focalDistance(pose: CameraPose, width: number, height: number, x: number, y: number, depth: number): number {
  const slope = Math.tan((pose.fov * Math.PI) / 360) / (Math.min(width, height) / 2);
  const [right, down] = [(x + 0.5 - width / 2) * slope, (y + 0.5 - height / 2) * slope];
  return depth / Math.sqrt(1 + right * right + down * down);
}
