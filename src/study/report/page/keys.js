// Keyboard shortcuts and the overlay that lists them.
"use strict";
{
  const cycle = (list, current, step) => list[(list.indexOf(current) + step + list.length) % list.length];
  const step = (by) => {
    const { length } = ajar.data.images;
    ajar.set({ a: (ajar.state.a + by + length) % length });
  };
  const rounded = (value, digits) => Number(value.toFixed(digits));

  let beforeReference = null; // index of the image that space returns to
  const flipToReference = () => {
    const { reference } = ajar.data;
    const { a, b } = ajar.state;
    // Without a reference, between the two images of the split view.
    const other = reference ?? b;
    if (a !== other) {
      beforeReference = a;
      ajar.set({ a: other });
    } else if (beforeReference !== null) {
      ajar.set({ a: beforeReference });
    } else {
      step(1);
    }
  };

  const nextMap = (by) => {
    if (ajar.data.reference !== null) ajar.set({ map: cycle(["colour", ...Object.keys(ajar.errors)], ajar.state.map, by) });
  };
  const nextLayer = (by) => ajar.set({ layer: cycle(ajar.layerNames(), ajar.state.layer, by) });

  /// The exposure at which 99 % of the picture's values are below white.
  const exposeAutomatically = () => {
    const entry = ajar.pixels.get(ajar.data.images[ajar.state.a], ajar.state.layer);
    if (!entry) return;
    const sample = [];
    const stride = Math.max(1, Math.floor(entry.pixels.length / 20000));
    for (let i = 0; i < entry.pixels.length; i += stride) {
      const value = ajar.halfs[entry.pixels[i]];
      if (Number.isFinite(value)) sample.push(value);
    }
    sample.sort((a, b) => a - b);
    const white = sample[Math.floor(0.99 * sample.length)];
    if (white > 0) ajar.set({ exposure: ajar.clamp(rounded(-Math.log2(white), 1), -20, 20) });
  };

  const reset = () => {
    const { exposure, gamma, tone, map, shift } = ajar.initialState;
    ajar.set({ exposure, gamma, tone, map, shift });
  };

  ajar.copyLink = async () => {
    ajar.writeHash();
    const button = ajar.find("copy-link");
    try {
      await navigator.clipboard.writeText(location.href);
      button.textContent = "Copied";
    } catch {
      button.textContent = "Copy it from the address bar";
    }
    setTimeout(() => (button.textContent = "Copy link"), 1500);
  };

  const help = ajar.find("help");
  ajar.toggleHelp = () => (help.open ? help.close() : help.showModal());

  // [keys shown, what it does, {key: action}]; keys as KeyboardEvent.key has them.
  const groups = [
    ["Images", [
      ["1 – 9", "show that image", {}],
      ["Shift + 1 – 9", "put that image on the right of the split view", {}],
      ["← →", "previous, next image", { ArrowLeft: () => step(-1), ArrowRight: () => step(1), ArrowUp: () => step(-1), ArrowDown: () => step(1) }],
      ["Space", "flip to the reference and back", { " ": flipToReference }],
      ["s", "split view on or off", { s: () => ajar.set({ mode: ajar.state.mode === "flip" ? "split" : "flip" }) }],
      ["x", "exchange left and right", { x: () => ajar.set({ a: ajar.state.b, b: ajar.state.a }) }],
      ["l  L", "next, previous layer", { l: () => nextLayer(1), L: () => nextLayer(-1) }],
    ]],
    ["Place", [
      ["wheel  + −", "zoom at the cursor", { "+": () => ajar.zoomBy(Math.SQRT2), "=": () => ajar.zoomBy(Math.SQRT2), "-": () => ajar.zoomBy(Math.SQRT1_2) }],
      ["drag", "move the picture, a frame, the divider", {}],
      ["0", "one screen pixel per image pixel", { 0: ajar.zoomToPixels }],
      ["f  double click", "fit the whole image", { f: ajar.fit }],
      ["i", "insets on or off", { i: ajar.toggleInsets }],
      ["p", "panels on or off", { p: () => ajar.set({ panels: !ajar.state.panels }) }],
    ]],
    ["Display", [
      ["e  E", "exposure up, down by half a stop", {
        e: () => ajar.set({ exposure: ajar.clamp(rounded(ajar.state.exposure + 0.5, 2), -20, 20) }),
        E: () => ajar.set({ exposure: ajar.clamp(rounded(ajar.state.exposure - 0.5, 2), -20, 20) }),
      }],
      ["a", "exposure by itself: 99 % below white", { a: exposeAutomatically }],
      ["g  G", "gamma up, down", {
        g: () => ajar.set({ gamma: ajar.clamp(rounded(ajar.state.gamma + 0.1, 2), 0.1, 5) }),
        G: () => ajar.set({ gamma: ajar.clamp(rounded(ajar.state.gamma - 0.1, 2), 0.1, 5) }),
      }],
      ["t", "next tone curve", { t: () => ajar.set({ tone: cycle(Object.keys(ajar.tones), ajar.state.tone, 1) }) }],
      ["m  M", "next, previous error map", { m: () => nextMap(1), M: () => nextMap(-1) }],
      [",  .", "error map: show smaller, larger errors", {
        ",": () => ajar.set({ shift: ajar.clamp(ajar.state.shift - 1, -12, 12) }),
        ".": () => ajar.set({ shift: ajar.clamp(ajar.state.shift + 1, -12, 12) }),
      }],
      ["r", "display as at the start", { r: reset }],
    ]],
    ["Report", [
      ["Tab", "from control to control", {}],
      ["c", "copy a link to this view", { c: ajar.copyLink }],
      ["?", "this help", { "?": ajar.toggleHelp }],
    ]],
  ];

  const actions = Object.assign({}, ...groups.flatMap(([, shortcuts]) => shortcuts.map(([, , keys]) => keys)));
  const everywhere = ["?", "c"];

  const showDigit = (event) => {
    const digit = /^Digit([1-9])$/.exec(event.code)?.[1] ?? /^[1-9]$/.exec(event.key)?.[0];
    if (!digit) return false;
    const index = Number(digit) - 1;
    if (index < ajar.data.images.length) ajar.set(event.shiftKey ? { b: index, mode: "split" } : { a: index });
    return true;
  };

  const onKey = (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || (help.open && event.key !== "?")) return;
    const { target } = event;
    // Controls keep the keys they use themselves.
    if (target.matches("select, input[type=text]")) return;
    const moves = event.key.startsWith("Arrow") || event.key === " ";
    if (moves && target.matches("input, button, summary, [role=tab]") && !(event.key !== " " && target.closest("#list"))) return;
    if (ajar.state.tab !== "images" && !everywhere.includes(event.key)) return;
    if (ajar.state.tab === "images" && ajar.data.images.length > 0 && showDigit(event)) {
      event.preventDefault();
      return;
    }
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  };

  ajar.startKeys = () => {
    help.append(
      ajar.element("h2", { id: "help-title" }, "Keyboard and mouse"),
      ajar.element("div", { class: "help-groups" }, ...groups.map(([title, shortcuts]) =>
        ajar.element("section", {}, ajar.element("h3", {}, title), ajar.element("dl", {}, ...shortcuts.flatMap(([keys, text]) => [
          ajar.element("dt", {}, ...keys.split("  ").map((key) => ajar.element("kbd", {}, key))),
          ajar.element("dd", {}, text),
        ]))))),
      ajar.element("form", { method: "dialog" }, ajar.element("button", {}, "Close")),
    );
    // A click beside the dialog closes it, as Escape does.
    help.addEventListener("click", (event) => event.target === help && help.close());
    document.addEventListener("keydown", onKey);
    ajar.find("show-help").addEventListener("click", ajar.toggleHelp);
    ajar.find("copy-link").addEventListener("click", ajar.copyLink);
  };
}
