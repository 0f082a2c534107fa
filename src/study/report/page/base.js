// What every file of the page uses. Plain scripts share the one global object `ajar`: modules cannot be loaded from disk.
"use strict";
const ajar = {};

/// element("td", {class: "number"}, "text", child, …): texts are never parsed as HTML.
ajar.element = (name, attributes = {}, ...children) => {
  const node = name === "svg" ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    else if (value === true) node.setAttribute(key, "");
    else if (value !== false && value !== undefined) node.setAttribute(key, value);
  }
  node.append(...children.filter((child) => child !== undefined));
  return node;
};

ajar.find = (id) => document.getElementById(id);
ajar.clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/// Numbers that JSON cannot hold arrive as strings.
ajar.number = (value) => (typeof value === "string" ? Number(value) : value);

/// Short and of even precision: 4 significant digits, powers of ten where zeros would pile up.
ajar.format = (value, digits = 4) => {
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = () => {
    if (size >= 1e5 || size < 1e-3) return value.toExponential(digits - 1).replace("e+", "e");
    return size >= 10 ** (digits - 1) ? value.toFixed(0) : value.toPrecision(digits);
  };
  return text().replace(/-/g, "−");
};

ajar.formatBytes = (bytes) =>
  bytes >= 1e6 ? `${(bytes / 1e6).toFixed(bytes >= 1e7 ? 0 : 1)} MB` : `${Math.ceil(bytes / 1e3)} kB`;

/// At most one call of `action` per frame, however often it is asked for.
ajar.perFrame = (action) => {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      action();
    });
  };
};
