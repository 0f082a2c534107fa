// The server's side of WebSockets (RFC 6455), as much as a trial needs: no extensions.
import { createHash } from "node:crypto";

const kContinuation = 0;
const kText = 1;
const kBinary = 2;
const kClose = 8;
const kPing = 9;
const kPong = 10;

function encoded(opcode, payload) {
  const { length } = payload;
  const size = length < 126 ? 2 : length < 65536 ? 4 : 10;
  const head = Buffer.alloc(size);
  head[0] = 0x80 | opcode;
  head[1] = size === 2 ? length : size === 4 ? 126 : 127;
  if (size === 4) head.writeUInt16BE(length, 2);
  if (size === 10) head.writeBigUInt64BE(BigInt(length), 2);
  return Buffer.concat([head, payload]);
}

/// The first message of `buffer` and the rest, or null if it is not whole.
function decoded(buffer) {
  if (buffer.length < 2) return null;
  let length = buffer[1] & 127;
  let at = 2;
  if (length === 126) [length, at] = buffer.length < 4 ? [Infinity, 4] : [buffer.readUInt16BE(2), 4];
  else if (length === 127) [length, at] = buffer.length < 10 ? [Infinity, 10] : [Number(buffer.readBigUInt64BE(2)), 10];
  if (buffer.length < at + 4 + length) return null;
  const mask = buffer.subarray(at, at + 4);
  const payload = Buffer.from(buffer.subarray(at + 4, at + 4 + length)).map((byte, i) => byte ^ mask[i % 4]);
  return { isLast: (buffer[0] & 128) !== 0, opcode: buffer[0] & 15, payload, rest: buffer.subarray(at + 4 + length) };
}

/// Accepts the socket of an upgrade. `receive(text or Buffer)` and `closed()` are called.
export function accept(request, socket, { receive, closed }) {
  const key = createHash("sha1").update(request.headers["sec-websocket-key"] + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest("base64");
  socket.write(`HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${key}\r\n\r\n`);
  let buffer = Buffer.alloc(0);
  let isOpen = true;
  // Browsers send large messages in parts.
  let parts = [];
  let kind = kText;
  const close = (code) => {
    if (!isOpen) return;
    isOpen = false;
    const payload = Buffer.alloc(2);
    payload.writeUInt16BE(code);
    socket.end(encoded(kClose, payload));
    closed();
  };
  socket.on("data", (data) => {
    buffer = Buffer.concat([buffer, data]);
    for (let message; isOpen && (message = decoded(buffer)); ) {
      buffer = message.rest;
      if (message.opcode === kText || message.opcode === kBinary || message.opcode === kContinuation) {
        if (message.opcode !== kContinuation) [kind, parts] = [message.opcode, []];
        parts.push(message.payload);
        if (message.isLast) receive(kind === kText ? Buffer.concat(parts).toString() : Buffer.concat(parts));
      } else if (message.opcode === kPing) socket.write(encoded(kPong, message.payload));
      else if (message.opcode === kClose) close(1000);
    }
  });
  socket.on("close", () => close(1000));
  socket.on("error", () => close(1000));
  return {
    send(message) {
      if (isOpen) socket.write(encoded(typeof message === "string" ? kText : kBinary, Buffer.from(message)));
    },
    close,
  };
}
