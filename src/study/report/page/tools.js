// The row of controls over the picture.
"use strict";
{
  const labelled = (text, ...controls) => ajar.element("label", { class: "tool" }, ajar.element("span", {}, text), ...controls);

  const select = (key, options, title) =>
    ajar.element("select", { id: `tool-${key}`, title, onchange: (event) => ajar.set({ [key]: event.target.value }) },
      ...options.map(([value, text]) => ajar.element("option", { value }, text)));

  const slider = (key, low, high, step, title) => [
    ajar.element("input", { type: "range", id: `tool-${key}`, min: low, max: high, step, title,
      oninput: (event) => ajar.set({ [key]: Number(event.target.value) }) }),
    ajar.element("output", { id: `shown-${key}`, for: `tool-${key}` }),
  ];

  const button = (id, text, title, action) => ajar.element("button", { id, title, onclick: action }, text);

  const layerNames = () => [...new Set(ajar.data.images.flatMap((image) => image.layers.map(({ name }) => name)))];
  ajar.layerNames = layerNames;

  const build = () => {
    const errors = ajar.data.reference === null ? [] : Object.entries(ajar.errors).map(([key, { title }]) => [key, title]);
    const layers = layerNames().map((name) => [name, name || "picture"]);
    const tones = Object.entries(ajar.tones).map(([key, { title }]) => [key, title]);
    ajar.find("tools").replaceChildren(
      ajar.element("div", { class: "group" },
        button("mode-flip", "Flip", "One image at a time (s)", () => ajar.set({ mode: "flip" })),
        button("mode-split", "Split", "Two images side by side (s)", () => ajar.set({ mode: "split" }))),
      labelled("Show", select("map", [["colour", "Colour"], ...errors], "Colour or error against the reference (m)")),
      ...(layers.length > 1 ? [labelled("Layer", select("layer", layers, "Layer (l)"))] : []),
      labelled("Exposure", ...slider("exposure", -10, 10, 0.1, "Exposure in stops (e, Shift+e)")),
      labelled("Gamma", ...slider("gamma", 0.4, 3, 0.05, "Gamma on top of sRGB (g, Shift+g)")),
      labelled("Tone", select("tone", tones, "Tone curve (t)")),
      ajar.element("div", { class: "group end" },
        button("tool-insets", "Insets", "Crops of all images side by side (i)", ajar.toggleInsets),
        button("tool-fit", "Fit", "Whole image (f)", ajar.fit),
        button("tool-pixels", "1:1", "One screen pixel per image pixel (0)", ajar.zoomToPixels),
        ajar.element("output", { id: "shown-zoom", title: "Screen pixels per image pixel" })),
    );
  };

  const showZoom = () => {
    const { zoom } = ajar.view();
    ajar.find("shown-zoom").textContent = `${zoom < 1 ? (100 * zoom).toFixed(0) : Math.round(100 * zoom)} %`;
  };

  const update = () => {
    const { mode, map, layer, exposure, gamma, tone, insets } = ajar.state;
    ajar.find("mode-flip").setAttribute("aria-pressed", mode === "flip");
    ajar.find("mode-split").setAttribute("aria-pressed", mode === "split");
    ajar.find("tool-insets").setAttribute("aria-pressed", insets.length > 0);
    ajar.find("tool-map").value = map;
    if (ajar.find("tool-layer")) ajar.find("tool-layer").value = layer;
    ajar.find("tool-tone").value = tone;
    ajar.find("tool-exposure").value = exposure;
    ajar.find("tool-gamma").value = gamma;
    const sign = exposure > 0 ? "+" : exposure < 0 ? "−" : "";
    ajar.find("shown-exposure").textContent = `${sign}${Math.abs(exposure).toFixed(1)}`;
    ajar.find("shown-gamma").textContent = gamma.toFixed(2);
    for (const key of ["exposure", "gamma", "tone"]) ajar.find(`tool-${key}`).disabled = map !== "colour";
    if (tone === "zones") ajar.find("tool-gamma").disabled = true;
    showZoom();
  };

  ajar.startTools = () => {
    build();
    update();
    ajar.onChange(update);
    new ResizeObserver(showZoom).observe(ajar.find("viewer"));
  };
}
