// Puts the page together when data/report.js has handed over the report.
"use strict";
{
  /// Images whose pixels are worth having before they are asked for: the neighbours first.
  const byDistance = () => {
    const { a } = ajar.state;
    return [...ajar.data.images].sort((p, q) => Math.abs(p.index - a) - Math.abs(q.index - a));
  };
  const whenIdle = window.requestIdleCallback ?? ((action) => setTimeout(action, 30));
  let prefetching = false;
  const prefetch = () => {
    if (prefetching) return;
    prefetching = true;
    const next = () => {
      const { layer } = ajar.state;
      const image = byDistance().find((one) => ajar.layerOf(one, layer) && !ajar.pixels.has(one, layer) && !ajar.pixels.failure(one, layer));
      if (!image || !ajar.pixels.hasRoom(image)) {
        prefetching = false;
        return;
      }
      ajar.pixels.request(image, layer).then(() => {
        ajar.showValues();
        whenIdle(next);
      });
    };
    whenIdle(next);
  };

  const startTabs = (available) => {
    const tabs = ["images", "results"];
    const show = () => {
      for (const name of tabs) {
        const isShown = ajar.state.tab === name;
        ajar.find(name).hidden = !isShown;
        const tab = ajar.find(`tab-${name}`);
        tab.hidden = available.length < 2;
        tab.setAttribute("aria-selected", isShown);
        tab.tabIndex = isShown ? 0 : -1;
      }
    };
    for (const name of tabs) {
      const tab = ajar.find(`tab-${name}`);
      tab.addEventListener("click", () => ajar.set({ tab: name }));
      tab.addEventListener("keydown", (event) => {
        if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
        const other = tabs.find((one) => one !== name);
        ajar.set({ tab: other });
        ajar.find(`tab-${other}`).focus();
      });
    }
    ajar.onChange((changed) => changed.has("tab") && show());
    show();
  };

  const startState = (available) => {
    const { images, reference } = ajar.data;
    // The first that is no reference, beside the reference.
    const first = images.findIndex((_, index) => index !== reference);
    return {
      ...ajar.initialState,
      tab: available[0] ?? "results",
      a: Math.max(first, 0),
      b: reference ?? (images.length > 1 ? 1 : 0),
      layer: images[0]?.layers[0].name ?? "",
    };
  };

  const startImages = () => {
    ajar.startViewer();
    ajar.startTools();
    ajar.startPanels();
    ajar.startList();
    ajar.startInsets();
    ajar.onChange((changed) => changed.has("layer") && prefetch());
    prefetch();
  };

  /// Called by data/report.js.
  ajar.report = (data) => {
    ajar.data = data;
    data.images.forEach((image, index) => (image.index = index));
    document.title = data.title || "Ajar report";
    ajar.find("title").textContent = document.title;
    const { page, data: pixels } = data.size;
    ajar.find("footer").textContent =
      `Written by Ajar. Page ${ajar.formatBytes(page)}, data ${ajar.formatBytes(pixels)}; nothing is loaded from the network. ` +
      "Pixels are half floats; metrics were computed from the full values.";

    const results = ajar.makeResults();
    ajar.find("results").replaceChildren(...results);
    ajar.startPlots();
    const available = [...(data.images.length > 0 ? ["images"] : []), ...(results.length > 0 ? ["results"] : [])];
    if (available.length === 0) ajar.find("results").append(ajar.element("p", {}, "This report is empty."));

    ajar.startState = startState(available);
    ajar.readHash();
    startTabs(available);
    if (data.images.length > 0) startImages();
    ajar.startKeys();
    window.addEventListener("hashchange", ajar.readHash);
  };
}
