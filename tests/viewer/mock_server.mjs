// A server that looks like `ajar view` to its page (docs/develop/live-viewer.md), for trying the page without a renderer:
// node mock_server.mjs --page=FOLDER [--port=0] [--integrators=FILE]. Prints its address, then each message of the page
// as a line of JSON.
import { readFile } from "node:fs/promises";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { accept } from "./web_socket.mjs";

const option = (name, usual) => process.argv.find((one) => one.startsWith(`--${name}=`))?.slice(name.length + 3) ?? usual;
const page = option("page", ".");
const token = "0123456789abcdef0123456789abcdef";
const integratorsFile = option("integrators", "");

const kFiles = { "/": ["index.html", "text/html"], "/viewer.js": ["viewer.js", "text/javascript"], "/viewer.css": ["viewer.css", "text/css"] };
const kPolicy = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' data: blob:";

// ---------------------------------------------------------------- what is rendered

/// A room with two balls, by formulas: number of the object, depth, and light of a pixel.
function scene(x, y, width, height, turn) {
  const [u, v] = [(x - width / 2) / height, (y - height / 2) / height];
  const balls = [[-0.3 + turn, 0.15, 0.22, [0.9, 0.3, 0.15]], [0.32 + turn, 0.2, 0.17, [0.35, 0.5, 0.75]]];
  for (const [i, [cx, cy, radius, colour]] of balls.entries()) {
    const [a, b] = [(u - cx) / radius, (v - cy) / radius];
    const inside = 1 - a * a - b * b;
    if (inside <= 0) continue;
    const light = 0.05 + Math.max(0, 0.55 * Math.sqrt(inside) - 0.5 * b - 0.3 * a) + 6 * Math.exp(-60 * ((a + 0.3) ** 2 + (b + 0.45) ** 2));
    return { object: i + 2, depth: 4 - 0.5 * Math.sqrt(inside), light: colour.map((c) => c * light) };
  }
  const lamp = Math.abs(u - turn) < 0.15 && v < -0.42 && v > -0.47;
  if (lamp) return { object: 4, depth: 5, light: [19, 14.6, 9.6] };
  const floor = v > 0.36;
  const shade = 0.25 + 0.5 * Math.exp(-3 * ((u - turn) ** 2 + (v + 0.45) ** 2));
  return { object: 1, depth: floor ? 4.5 : 6, light: (floor ? [0.55, 0.5, 0.45] : [0.74, 0.73, 0.7]).map((c) => c * shade) };
}

const kObjects = ["room", "copper ball", "glass ball with a long name in the file", "lamp"];
const kMaterials = ["white", "copper", "glass", "lamp"];

const state = {
  type: "state", phase: "rendering", message: "", epoch: 1, width: 640, height: 360, crop: [0, 0, 640, 360], samples: 0, seconds: 0,
  rays_per_second: 2.31e6, mutations_per_second: 184000, error: null, error_is_lower_bound: false, layers: ["", "denoised", "depth", "object-id", "noise", "regions", "samples", "normal"],
  integrator: "selective", parameters: {}, rules: [], masked: false,
  camera: { position: [0, 1, 5], target: [0, 1, 0], up: [0, 1, 0], fov: 40, lens_radius: 0, focal_distance: 1e6 },
  stop_at: { samples: null, seconds: null, error: null }, can_undo: false, can_redo: false, done: null, chain_share: 0.34,
  acceptance: [{ move: "lens", acceptance: 0.62 }, { move: "caustic", acceptance: 0.21 }, { move: "large step", acceptance: 0.08 }],
};
const kUsualIntegrators = [
  { name: "selective", summary: "chains where they pay", source: "", parameters: [
    { name: "chain", type: "choice", default: "mlt", unit: "", expert: false, help: "how chains walk", choices: ["mlt", "pssmlt"] },
    { name: "regions", type: "text", default: "", unit: "", expert: false, help: "a file" },
    { name: "sigma", type: "float", default: "0.01", unit: "pixels", expert: false, help: "size of small steps", minimum: 0, maximum: 1, depends_on: "chain", matters_for: ["pssmlt"] },
    { name: "pilot", type: "int", default: "16", unit: "samples", expert: true, help: "per pixel, before chains start", minimum: 1, maximum: 4096 },
  ] },
  { name: "pt", summary: "path tracing", source: "Kajiya 1986", parameters: [] },
];
const welcome = {
  type: "welcome", scene: "/scenes/two-balls/scene.pbrt", version: "0.0 mock",
  integrators: integratorsFile ? JSON.parse(readFileSync(integratorsFile, "utf8")) : { integrators: kUsualIntegrators },
  layers: [["", "the picture"], ["denoised", "the picture without noise"], ["depth", "distance from the camera to the first surface, scene units"],
    ["object-id", "number of the shape"], ["noise", "impulse noise of the pilot's indirect light"], ["regions", "number of the region of a pixel, from 1"],
    ["samples", "samples per pixel"], ["normal", "shading normal"]].map(([name, help]) => ({ name, help })),
  objects: kObjects, materials: kMaterials,
  parts: { materials: [
    { name: "white", model: "diffuse", parameters: { reflectance: [0.74, 0.73, 0.7], sigma: 0, between_facets: false } },
    { name: "copper", model: "conductor", parameters: { eta: [0.2, 0.92, 1.1], k: [3.9, 2.45, 2.14], reflectance: null, distribution: "ggx", roughness: 0.1 } },
    { name: "glass", model: "dielectric", parameters: { reflectance: { texture: 3 }, transmittance: [1, 1, 1], eta: 1.5, thin: false, roughness: 0 } },
  ], lights: [{ name: "", model: "environment", parameters: { radiance: [2.5, 1.2, 0.4] } }], shapes: [], textures: [] },
};

const turn = () => state.camera.position[0] / 10;

function halfOf(number) {
  const bits = new Uint32Array(new Float32Array([number]).buffer)[0];
  const sign = (bits >>> 16) & 0x8000;
  const exponent = ((bits >>> 23) & 255) - 112;
  if (exponent <= 0) return sign;
  if (exponent >= 31) return sign | 0x7c00;
  return sign | (exponent << 10) | ((bits >>> 13) & 1023);
}

let seed = 1;
const random = () => ((seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) + 0.5) / 2 ** 32;

function valueOf(layer, x, y) {
  const { object, depth, light } = scene(x, y, state.width, state.height, turn());
  if (layer === "depth") return [depth];
  if (layer === "object-id") return [object];
  if (layer === "noise") return [object === 3 ? 3 + random() : 0.01 * (1 + random())];
  if (layer === "regions") return [object === 3 ? 2 : 1];
  if (layer === "samples") return [state.samples];
  if (layer === "normal") return [0.1 * object, 0.5, 1];
  const spread = layer === "denoised" ? 0 : Math.min(1, 0.8 / Math.sqrt(Math.max(state.samples, 1)));
  const factor = 1 + spread * (-Math.log(random()) - 1);
  return light.map((c) => c * factor);
}

function frameOf(number, wanted, step) {
  const layer = state.layers.includes(wanted) ? wanted : "";
  const [x0, y0, x1, y1] = state.crop;
  const [columns, rows] = [Math.ceil((x1 - x0) / step), Math.ceil((y1 - y0) / step)];
  const channels = ["", "denoised", "normal"].includes(layer) ? 3 : 1;
  const start = 28 + 4 * Math.ceil(layer.length / 4);
  const bytes = Buffer.alloc(start + 2 * channels * columns * rows);
  bytes.write("AJF1");
  bytes.writeUInt32LE(number, 4);
  bytes.writeUInt32LE(state.epoch, 8);
  [state.width, state.height, x0, y0, x1 - x0, y1 - y0, step].forEach((value, i) => bytes.writeUInt16LE(value, 12 + 2 * i));
  bytes[26] = channels;
  bytes[27] = layer.length;
  bytes.write(layer, 28);
  let at = start;
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      for (const value of valueOf(layer, x0 + column * step, y0 + row * step)) at = bytes.writeUInt16LE(halfOf(value), at);
    }
  }
  return bytes;
}

// ---------------------------------------------------------------- messages

const kUndoable = ["integrator", "parameters", "rules", "camera", "masked", "width", "height", "crop"];
const kept = () => JSON.stringify(Object.fromEntries(kUndoable.map((key) => [key, state[key]])));
const [done, undone] = [[], []];
const history = [];
let isMoving = false;

function step(from, to) {
  if (from.length === 0) return;
  to.push(kept());
  Object.assign(state, JSON.parse(from.pop()));
  begin();
}

function begin() {
  ++state.epoch;
  state.samples = 0;
  state.seconds = 0;
  history.length = 0;
}

function change(values) {
  if (!isMoving) done.push(kept());
  undone.length = 0;
  Object.assign(state, values);
  begin();
}

function answer(client, message) {
  const { type, ...members } = message;
  if (type === "ack") client.drawn = members.frame;
  else if (type === "layer") [client.layer, client.isFinest] = [members.name, false];
  else if (type === "pause") state.phase = "paused";
  else if (type === "resume") state.phase = "rendering";
  else if (type === "restart") begin();
  else if (type === "stop-at") state.stop_at = members;
  else if (type === "method") change(members);
  else if (type === "regions") change({ rules: members.rules.map((rule) => ({ ...rule, choice: String(rule.choice) })) });
  else if (type === "resolution") change({ ...members, crop: [0, 0, members.width, members.height] });
  else if (type === "crop") change({ crop: members.window ?? [0, 0, state.width, state.height] });
  else if (type === "edit") change({});
  else if (type === "undo") step(done, undone);
  else if (type === "redo") step(undone, done);
  else if (type === "save") client.send({ type: "saved", path: `/pictures/two-balls-1.${members.format}` });
  else if (type === "camera") {
    const { moving, ...camera } = members;
    change({ camera });
    isMoving = moving;
  } else if (type === "inspect") {
    const { object, depth, light } = scene(members.x, members.y, state.width, state.height, turn());
    const thing = (names) => ({ number: object, name: names[object - 1] });
    client.send({ type: "pixel", ...members, values: { "": light, depth: [depth], "object-id": [object], normal: [0, null, 1] }, object: thing(kObjects), material: thing(kMaterials), region: object === 3 ? 2 : 1, samples: state.samples, error: 0.04 });
  } else client.send({ type: "note", level: "warning", text: `unknown type ${type}` });
}

const clients = new Set();

function tick() {
  if (state.phase === "rendering") {
    state.samples += 2;
    state.seconds += 0.25;
    state.error = state.samples < 6 ? null : 0.4 / Math.sqrt(state.samples);
    state.error_is_lower_bound = state.samples < 20;
    if (state.error) history.push([state.seconds, state.error]);
  }
  Object.assign(state, { can_undo: done.length > 0, can_redo: undone.length > 0, done: state.stop_at.samples ? Math.min(1, state.samples / state.stop_at.samples) : null });
  for (const client of clients) {
    client.send(state);
    client.send({ type: "history", points: history });
    if (client.drawn !== client.sent) continue;
    client.socket.send(frameOf(++client.sent, client.layer, state.samples < 4 ? 4 : 1));
  }
}

function open(request, socket) {
  const client = { layer: "", sent: 0, drawn: 0, socket: null, send: (message) => client.socket.send(JSON.stringify(message)) };
  let isKnown = false;
  client.socket = accept(request, socket, {
    closed: () => clients.delete(client),
    receive: (data) => {
      if (typeof data !== "string") {
        console.log(JSON.stringify({ type: "mask", magic: data.toString("latin1", 0, 4), width: data.readUInt32LE(4), height: data.readUInt32LE(8), painted: data.subarray(12).filter((byte) => byte !== 255).length }));
        change({ masked: data.length > 12 });
        return;
      }
      const message = JSON.parse(data);
      if (message.type !== "ack" && message.type !== "inspect") console.log(data);
      if (isKnown) {
        answer(client, message);
      } else if (message.type === "hello" && message.token === token && message.version === 1) {
        isKnown = true;
        clients.add(client);
        client.send(welcome);
        client.send(state);
        client.send({ type: "note", level: "note", text: "the mock server renders formulas" });
      } else {
        client.socket.close(1008);
      }
    },
  });
}

const server = createServer(async (request, response) => {
  const file = kFiles[new URL(request.url, "http://localhost").pathname];
  if (!file) {
    response.writeHead(404).end();
    return;
  }
  response.writeHead(200, { "Content-Type": `${file[1]}; charset=utf-8`, "Content-Security-Policy": kPolicy, "Cache-Control": "no-store" });
  response.end(await readFile(join(page, file[0])));
});
server.on("upgrade", (request, socket) => {
  if (request.headers.origin === `http://${request.headers.host}`) open(request, socket);
  else socket.destroy();
});
server.listen(Number(option("port", "0")), "127.0.0.1", () => console.log(`http://127.0.0.1:${server.address().port}/#${token}`));
setInterval(tick, 250);
