import type { App } from "./app";
import { find } from "./dom";
import type { ShortcutGroup } from "./keys";

const kHintKey = "ajar-hint-seen";

/// The dialog of shortcuts.
export function makeHelp(groups: ShortcutGroup[]): void {
  const help = find<HTMLDialogElement>("help");
  help.append(
    ajar.element("h2", { id: "help-title" }, "Keyboard and mouse"),
    ajar.element("div", { class: "help-groups" }, ...groups.map(({ title, shortcuts }) =>
      ajar.element("section", {}, ajar.element("h3", {}, title), ajar.element("dl", {}, ...shortcuts.flatMap(({ keys, text }) => [
        ajar.element("dt", {}, ...keys.split("  ").map((key) => ajar.element("kbd", {}, key))),
        ajar.element("dd", {}, text),
      ]))))),
    ajar.element("form", { method: "dialog" }, ajar.element("button", { autofocus: true }, "Close")),
  );
  // A click beside the dialog closes it, as Escape does.
  help.addEventListener("click", (event) => event.target === help && help.close());
  find("show-help").addEventListener("click", toggleHelp);
}

export function toggleHelp(): void {
  const help = find<HTMLDialogElement>("help");
  if (help.open) help.close();
  else help.showModal();
}

/// Says once in a browser how the page is meant.
export function showHint(app: App): void {
  const hint = find("hint");
  hint.hidden = localStorage.getItem(kHintKey) !== null;
  // A finished picture is not for steering.
  app.stated.on(({ phase }) => (hint.hidden ||= phase === "finished"));
  find("close-hint").addEventListener("click", () => {
    hint.hidden = true;
    localStorage.setItem(kHintKey, "1");
    find("viewer").focus();
  });
}
