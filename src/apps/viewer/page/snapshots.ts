import type { App } from "./app";
import { button, find, shortOf } from "./dom";
import type { Frame } from "./frame";
import { Signal } from "./signal";

/// A picture that was kept, A, beside the present one: in halves, or in turns.
export class Snapshots {
  kept: { frame: Frame; caption: string } | null = null;
  readonly changed = new Signal();
  private isSplit = false;
  private isFlipped = false;
  private share = 0.5;

  private readonly divider = find("divider");
  private readonly keepButton = button("Keep A", "Keep the present picture as A, beside what follows (a)", () => this.keep(), { id: "keep" });
  private readonly splitButton = button("Split", "A in the left half (Shift+a)", () => this.toggleSplit(), { id: "split", disabled: true });
  private readonly flipButton = button("Flip", "A or the present picture in turns (x)", () => this.flip(), { id: "flip", disabled: true });
  private readonly dropButton = button("✕", "Forget A", () => this.drop(), { id: "drop", disabled: true, "aria-label": "Forget A" });

  constructor(private readonly app: App) {
    find("snapshots").append(this.keepButton, this.splitButton, this.flipButton, this.dropButton);
    this.divider.addEventListener("pointerdown", (event) => this.drag(event));
    this.divider.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -0.02, ArrowRight: 0.02 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      this.moveTo(this.share + step);
    });
    this.show();
  }

  keep(): void {
    const { frame, state } = this.app;
    if (!frame) return;
    const parts = [frame.layer, state?.integrator, state ? `${shortOf(state.samples)} spp` : ""];
    this.kept = { frame, caption: parts.filter(Boolean).join(" · ") };
    this.isSplit = true;
    this.isFlipped = false;
    this.show();
  }

  toggleSplit(): void {
    if (!this.kept) return;
    this.isSplit = !this.isSplit;
    this.isFlipped = false;
    this.show();
  }

  flip(): void {
    if (!this.kept) return;
    this.isFlipped = this.isSplit || !this.isFlipped;
    this.isSplit = false;
    this.show();
  }

  drop(): void {
    this.kept = null;
    this.isSplit = false;
    this.isFlipped = false;
    this.show();
  }

  /// A is left of `left`, the present picture from there up to `right`.
  columns(width: number): { left: number; right: number } {
    const left = this.isSplit ? Math.round(this.share * width) : this.isFlipped ? width : 0;
    return { left, right: width };
  }

  private moveTo(share: number): void {
    this.share = ajar.clamp(share, 0, 1);
    this.show();
  }

  private drag(event: PointerEvent): void {
    event.preventDefault();
    event.stopPropagation();
    this.divider.focus();
    this.divider.setPointerCapture(event.pointerId);
    const box = find("viewer").getBoundingClientRect();
    const move = (moved: PointerEvent) => this.moveTo((moved.clientX - box.left) / box.width);
    const end = () => {
      this.divider.removeEventListener("pointermove", move);
      this.divider.removeEventListener("lostpointercapture", end);
    };
    this.divider.addEventListener("pointermove", move);
    this.divider.addEventListener("lostpointercapture", end);
  }

  private show(): void {
    const { kept, isSplit, isFlipped } = this;
    for (const one of [this.splitButton, this.flipButton, this.dropButton]) one.disabled = !kept;
    this.splitButton.setAttribute("aria-pressed", String(isSplit));
    this.flipButton.setAttribute("aria-pressed", String(isFlipped));
    this.divider.hidden = !isSplit;
    this.divider.style.left = `${100 * this.share}%`;
    this.divider.setAttribute("aria-valuenow", String(Math.round(100 * this.share)));
    const [a, b] = [find("label-a"), find("label-b")];
    a.hidden = !kept || !(isSplit || isFlipped);
    b.hidden = !kept || isFlipped;
    a.replaceChildren(ajar.element("b", {}, "A"), ` ${kept?.caption ?? ""}`);
    b.replaceChildren(ajar.element("b", {}, "Now"));
    this.changed.emit();
  }
}
