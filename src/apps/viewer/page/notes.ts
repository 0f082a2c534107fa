import type { App } from "./app";
import { button, find } from "./dom";

/// Milliseconds that a note stays. Warnings stay until they are closed.
const kStays = 7000;
const kMost = 5;

/// Notes of the server and of the page, over the picture's corner.
export function showNotes(app: App): void {
  const list = find("notes");
  app.note.on(({ level, text }) => {
    const same = [...list.children].find((one) => one.firstChild?.textContent === text);
    same?.remove();
    const row = ajar.element("li", { class: `card ${level}` }, ajar.element("span", {}, text),
      button("✕", "Close", () => row.remove(), { class: "small", "aria-label": "Close the note" }));
    list.append(row);
    while (list.children.length > kMost) list.firstElementChild?.remove();
    if (level === "note") setTimeout(() => row.remove(), kStays);
  });
}
