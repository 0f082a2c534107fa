import type { FromServer, ToServer } from "./protocol";
import { Signal } from "./signal";

const kTokenKey = "ajar-token";
/// Milliseconds until the next try, doubled up to the second.
const kFirstWait = 500;
const kLongestWait = 15000;
/// Close code of a server that does not know the token (RFC 6455, 7.4.1: policy violation).
const kRefused = 1008;

/// The token of the address, or of this tab before it was loaded anew. It leaves the address bar.
function takeToken(): string {
  const fromAddress = location.hash.slice(1);
  if (fromAddress) {
    history.replaceState(null, "", location.pathname + location.search);
    sessionStorage.setItem(kTokenKey, fromAddress);
  }
  return sessionStorage.getItem(kTokenKey) ?? "";
}

export interface Connection {
  isOpen: boolean;
  /// Shown where it is not open.
  reason: string;
}

/// The connection with the server, which it makes again where it breaks.
export class Socket {
  readonly connection = new Signal<Connection>();
  readonly message = new Signal<FromServer>();
  readonly frame = new Signal<ArrayBuffer>();

  private readonly token = takeToken();
  private socket: WebSocket | null = null;
  private wait = kFirstWait;
  private timer = 0;
  private wasWelcome = false;

  constructor(private readonly url = `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/socket`) {
    addEventListener("online", () => this.tryNow());
    // The address of another run, put into the bar of this tab.
    addEventListener("hashchange", () => {
      if (location.hash.length > 1) location.reload();
    });
  }

  connect(): void {
    if (!this.token) {
      this.tell("This tab has no key. Open the whole address that ajar view has printed, with the part after #.");
      return;
    }
    const socket = new WebSocket(this.url);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    let wasOpen = false;
    socket.onopen = () => {
      wasOpen = true;
      this.send({ type: "hello", token: this.token, version: 1 });
    };
    socket.onmessage = ({ data }) => this.receive(data as string | ArrayBuffer);
    socket.onclose = ({ code }) => {
      this.socket = null;
      if (code === kRefused && !this.wasWelcome) {
        this.tell("The server refused the key of this tab: it is of another run. Open the address that ajar view has printed.");
        return;
      }
      this.tryLater(wasOpen ? "The connection has ended." : "The server does not answer. It may have ended.");
      this.wasWelcome = false;
    };
  }

  /// Without effect where it is not open: the state that follows a new connection says what holds.
  send(message: ToServer | ArrayBuffer): void {
    if (this.socket?.readyState !== WebSocket.OPEN) return;
    this.socket.send(message instanceof ArrayBuffer ? message : JSON.stringify(message));
  }

  tryNow(): void {
    if (this.socket || !this.timer) return;
    clearTimeout(this.timer);
    this.timer = 0;
    this.connect();
  }

  private receive(data: string | ArrayBuffer): void {
    if (!this.wasWelcome) {
      this.wasWelcome = true;
      this.wait = kFirstWait;
      this.connection.emit({ isOpen: true, reason: "" });
    }
    if (typeof data === "string") this.message.emit(JSON.parse(data) as FromServer);
    else this.frame.emit(data);
  }

  private tell(reason: string): void {
    this.connection.emit({ isOpen: false, reason });
  }

  private tryLater(reason: string): void {
    const seconds = Math.max(1, Math.round(this.wait / 1000));
    this.tell(`${reason} Trying again in ${seconds} s.`);
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      this.connect();
    }, this.wait);
    this.wait = Math.min(2 * this.wait, kLongestWait);
  }
}
