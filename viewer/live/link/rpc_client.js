// JSON-RPC 2.0 over a WebSocket that comes back by itself when the server does.

const FIRST_WAIT = 250; // [ms]
const LONGEST_WAIT = 4000; // [ms]

/// What a request failed with: `code` of JSON-RPC, or "lost" where the connection went.
export class RpcError extends Error {
  constructor(message, code) {
    super(message);
    this.code = code;
  }
}

/// A connection to `url`. `heard` has functions that are told: frame(ArrayBuffer), notice(method,
/// params), link({ connected, wait [ms], lost: methods that got no answer }). `openSocket(url)` and `later(work, ms)` are
/// there for tests. Returns { call(method, params) -> promise of the result, connected(), waiting(),
/// close() }; requests while there is no connection fail at once, those in flight when it goes fail then.
export function rpcClient(
  url,
  heard,
  {
    openSocket = (address) => new WebSocket(address),
    later = (work, ms) => setTimeout(work, ms),
  } = {},
) {
  const flying = new Map();
  let socket = null;
  let next = 1;
  let failures = 0;
  let closed = false;

  function answer({ id, result, error }) {
    const request = flying.get(id);
    if (!request) {
      if (error) heard.notice("error", error);
      return;
    }
    flying.delete(id);
    if (error) request.reject(new RpcError(error.message ?? "failed", error.code));
    else request.resolve(result);
  }

  function read(data) {
    if (typeof data !== "string") return heard.frame(data);
    const message = JSON.parse(data);
    if (message.method) heard.notice(message.method, message.params ?? {});
    else answer(message);
  }

  function lose() {
    const lost = [...flying.values()].map(({ method }) => method);
    for (const { method, reject } of flying.values())
      reject(new RpcError(`the connection was lost before ${method} was answered`, "lost"));
    flying.clear();
    socket = null;
    if (closed) return;
    const wait = Math.min(LONGEST_WAIT, FIRST_WAIT * 2 ** failures++);
    heard.link({ connected: false, wait, lost });
    later(open, wait);
  }

  function open() {
    if (closed) return;
    const opened = openSocket(url);
    opened.binaryType = "arraybuffer";
    opened.onopen = () => {
      failures = 0;
      socket = opened;
      heard.link({ connected: true, wait: 0, lost: [] });
    };
    opened.onmessage = ({ data }) => read(data);
    opened.onclose = lose;
  }

  function call(method, params = {}) {
    if (!socket)
      return Promise.reject(new RpcError("thenar is not connected", "not connected"));
    const id = next++;
    return new Promise((resolve, reject) => {
      flying.set(id, { method, resolve, reject });
      socket.send(JSON.stringify({ jsonrpc: "2.0", id, method, params }));
    });
  }

  open();
  return {
    call,
    connected: () => socket !== null,
    waiting: () => [...flying].map(([id, { method }]) => ({ id, method })),
    close: () => {
      closed = true;
      socket?.close();
    },
  };
}
