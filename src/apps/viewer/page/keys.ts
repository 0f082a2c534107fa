/// A shortcut: keys as they are shown, its meaning, and what happens by KeyboardEvent.key.
export interface Shortcut {
  keys: string;
  text: string;
  actions: Record<string, () => void>;
}

export interface ShortcutGroup {
  title: string;
  shortcuts: Shortcut[];
}

/// Whether the control under the focus needs the key itself.
function isTaken(event: KeyboardEvent): boolean {
  const { target, key } = event;
  if (!(target instanceof Element)) return false;
  if (target.matches("input:not([type=range]):not([type=checkbox]), select, textarea")) return true;
  return (key === " " || key === "Enter" || key.startsWith("Arrow")) && target.matches("button, input, summary, [role=slider]");
}

/// Calls the actions of the groups. `first` may take a key before them.
export function listen(groups: ShortcutGroup[], first: (event: KeyboardEvent) => boolean): void {
  const actions: Record<string, () => void> = Object.assign({}, ...groups.flatMap(({ shortcuts }) => shortcuts.map((one) => one.actions)));
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isTaken(event)) return;
    if (document.querySelector("dialog[open]") && event.key !== "?") return;
    if (first(event)) {
      event.preventDefault();
      return;
    }
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
  document.addEventListener("keyup", (event) => first(event));
}
