import { App } from "./app";
import { Brush } from "./brush";
import { Camera } from "./camera";
import { Controls } from "./controls";
import { Crop } from "./crop";
import { find } from "./dom";
import { Edits } from "./edits";
import { decodeFrame } from "./frame";
import { makeHelp, showHint, toggleHelp } from "./help";
import { Inspector } from "./inspector";
import { listen, type ShortcutGroup } from "./keys";
import { Layers } from "./layers";
import { Method } from "./method";
import { showNotes } from "./notes";
import { Plot } from "./plot";
import type { FromServer } from "./protocol";
import { Regions } from "./regions";
import { Snapshots } from "./snapshots";
import { Stage } from "./stage";
import { Status } from "./status";
import { Tools } from "./tools";

function dispatch(app: App, message: FromServer): void {
  switch (message.type) {
    case "welcome":
      app.welcome = message;
      app.welcomed.emit(message);
      break;
    case "state":
      app.state = message;
      app.stated.emit(message);
      break;
    case "history":
      app.history.emit(message);
      break;
    case "pixel":
      app.pixel.emit(message);
      break;
    case "note":
      app.note.emit(message);
      break;
    case "saved":
      app.saved.emit(message);
      break;
  }
}

function togglePanels(): void {
  const isBare = document.body.classList.toggle("bare");
  find("toggle-panels").setAttribute("aria-expanded", String(!isBare));
}

function shortcuts(app: App, stage: Stage, tools: Tools, layers: Layers, snapshots: Snapshots, controls: Controls): ShortcutGroup[] {
  const { view, display, changes } = app;
  const zoomIn = () => view.zoomBy(Math.SQRT2, stage.mousePlace());
  const zoomOut = () => view.zoomBy(Math.SQRT1_2, stage.mousePlace());
  const expose = (by: number) => () => display.set({ exposure: display.exposure + by });
  return [
    { title: "Render", shortcuts: [
      { keys: "Space", text: "pause, go on", actions: { " ": () => controls.togglePause() } },
      { keys: "z  Z", text: "undo, redo", actions: { z: () => changes.undo(), Z: () => changes.redo() } },
      { keys: "s  S", text: "save as EXR, as PNG", actions: { s: () => controls.save("exr"), S: () => controls.save("png") } },
    ] },
    { title: "Tools", shortcuts: tools.list.map(({ name, key, help }) => ({ keys: key, text: help, actions: { [key]: () => tools.choose(name) } })) },
    { title: "Place", shortcuts: [
      { keys: "wheel  +  −", text: "zoom; with Ctrl also where a tool has the wheel", actions: { "+": zoomIn, "=": zoomIn, "-": zoomOut } },
      { keys: "f", text: "whole picture", actions: { f: () => view.fit() } },
      { keys: "1", text: "one screen pixel per image pixel", actions: { 1: () => view.toPixels(stage.mousePlace()) } },
      { keys: "right drag", text: "move the picture with any tool", actions: {} },
      { keys: "p", text: "panels on or off", actions: { p: togglePanels } },
    ] },
    { title: "Display", shortcuts: [
      { keys: "e  E", text: "exposure up, down by half a stop", actions: { e: expose(0.5), E: expose(-0.5) } },
      { keys: "l  L", text: "next, previous layer", actions: { l: () => layers.step(1), L: () => layers.step(-1) } },
      { keys: "t", text: "next tone curve", actions: { t: () => layers.nextTone() } },
      { keys: "a  A", text: "keep the picture as A, split view on or off", actions: { a: () => snapshots.keep(), A: () => snapshots.toggleSplit() } },
      { keys: "x", text: "flip between A and now", actions: { x: () => snapshots.flip() } },
      { keys: "?", text: "this help", actions: { "?": toggleHelp } },
    ] },
  ];
}

function start(): void {
  const app = new App();
  const tools = new Tools();
  const snapshots = new Snapshots(app);
  const stage = new Stage(app, tools, snapshots);
  const layers = new Layers(app, stage);
  const inspector = new Inspector(app, stage, tools);
  const edits = new Edits(app);
  new Regions(app, tools, inspector, (name) => edits.showMaterial(name));
  new Brush(app, stage, tools);
  const camera = new Camera(app, tools, inspector);
  new Crop(app, stage, tools);
  new Method(app);
  const controls = new Controls(app);
  new Plot(app);
  new Status(app);
  showNotes(app);
  tools.show();

  const groups = shortcuts(app, stage, tools, layers, snapshots, controls);
  makeHelp(groups);
  showHint(app);
  listen(groups, (event) => camera.key(event));
  find("toggle-panels").addEventListener("click", togglePanels);

  app.socket.message.on((message) => dispatch(app, message));
  app.socket.frame.on((message) => app.framed.emit(decodeFrame(message)));
  app.socket.connection.on(({ isOpen }) => {
    if (!isOpen) return;
    app.changes.forget();
    if (app.layer) app.showLayer(app.layer);
  });
  app.socket.connect();

  // For tests and consoles.
  Object.assign(globalThis, {
    ajarView: {
      get state() { return app.state; },
      get frame() { return stage.drawn; },
      pixel: (x: number, y: number) => stage.shown(x, y),
      place: (x: number, y: number) => stage.windowPlace(x, y),
    },
  });
}

try {
  start();
} catch (error) {
  find("offline").hidden = false;
  find("offline-title").textContent = "The page cannot start";
  find("offline-reason").textContent = error instanceof Error ? error.message : String(error);
  console.error(error);
}
