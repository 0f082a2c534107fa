// What the reader sees, in one place, and in the URL so that it can be sent.
"use strict";
{
  const initial = {
    tab: "images",
    a: 0, // the image; on the left in split view
    b: 0, // on the right in split view
    mode: "flip", // or "split"
    split: 0.5, // share of the viewer's width
    layer: "",
    map: "colour", // or a name of ajar.errors
    shift: 0, // decades by which the range of error maps is moved
    exposure: 0, // stops
    gamma: 1, // on top of the sRGB curve
    tone: "srgb", // a name of ajar.tones
    zoom: 0, // device pixels per image pixel; 0: fit
    x: 0, // image point in the middle of the viewer
    y: 0,
    insets: [], // {x, y, size} in image pixels, corner and side
    panels: true,
  };

  const listeners = [];
  const state = structuredClone(initial);
  ajar.state = state;
  ajar.initialState = initial;

  /// Calls `listener(changed keys)` after each change.
  ajar.onChange = (listener) => listeners.push(listener);

  ajar.set = (changes) => {
    const changed = new Set();
    for (const [key, value] of Object.entries(changes)) {
      if (state[key] !== value) changed.add(key);
      state[key] = value;
    }
    if (changed.size === 0) return;
    for (const listener of listeners) listener(changed);
    writeLater();
  };

  // Indices count from 1 in the URL, as the keys do.
  const write = {
    a: (v) => v + 1,
    b: (v) => v + 1,
    split: (v) => v.toFixed(3),
    zoom: (v) => Number(v.toPrecision(5)),
    x: (v) => v.toFixed(1),
    y: (v) => v.toFixed(1),
    exposure: (v) => Number(v.toFixed(3)),
    gamma: (v) => Number(v.toFixed(3)),
    insets: (list) => list.map(({ x, y, size }) => `${x}.${y}.${size}`).join("-"),
    panels: (v) => (v ? 1 : 0),
  };
  const image = (text) => ajar.clamp(Math.round(Number(text)) - 1 || 0, 0, Math.max(ajar.data.images.length - 1, 0));
  const finite = (low, high, otherwise) => (text) =>
    Number.isFinite(Number(text)) ? ajar.clamp(Number(text), low, high) : otherwise;
  const oneOf = (names, otherwise) => (text) => (names.includes(text) ? text : otherwise);
  // Whatever the URL says, the state is valid.
  const read = {
    tab: oneOf(["images", "results"], "images"),
    a: image,
    b: image,
    mode: oneOf(["flip", "split"], "flip"),
    split: finite(0, 1, 0.5),
    layer: (text) => text,
    map: (text) => (text in ajar.errors && ajar.data.reference !== null ? text : "colour"),
    shift: finite(-12, 12, 0),
    exposure: finite(-20, 20, 0),
    gamma: finite(0.1, 5, 1),
    tone: oneOf(Object.keys(ajar.tones), "srgb"),
    zoom: finite(0, 512, 0),
    x: finite(-1e5, 1e5, 0),
    y: finite(-1e5, 1e5, 0),
    insets: (text) =>
      text
        .split("-")
        .map((part) => part.split(".").map(Number))
        .filter((part) => part.length === 3 && part.every(Number.isInteger) && part[2] > 0)
        .slice(0, ajar.kMaxInsets)
        .map(([x, y, size]) => ({ x, y, size })),
    panels: (text) => text !== "0",
  };

  /// The state as the part of the URL after #; only what differs from the start.
  ajar.hash = () => {
    const parts = new URLSearchParams();
    for (const [key, value] of Object.entries(state)) {
      const text = String((write[key] ?? String)(value));
      if (text !== String((write[key] ?? String)(ajar.startState[key]))) parts.set(key, text);
    }
    return parts.toString();
  };

  let timer = 0;
  // Browsers refuse more than some hundred changes of the URL in a minute.
  const writeLater = () => {
    clearTimeout(timer);
    timer = setTimeout(ajar.writeHash, 300);
  };
  ajar.writeHash = () => {
    const hash = ajar.hash();
    if (hash !== location.hash.slice(1)) history.replaceState(null, "", `#${hash}`);
  };

  /// Takes over what the URL says on top of the report's start.
  ajar.readHash = () => {
    const changes = structuredClone(ajar.startState);
    for (const [key, text] of new URLSearchParams(location.hash.slice(1))) {
      if (key in read) changes[key] = read[key](text);
    }
    ajar.set(changes);
  };
}
