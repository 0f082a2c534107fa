/// Listeners of one kind of event, called in the order in which they came.
export class Signal<Value = void> {
  private readonly listeners: ((value: Value) => void)[] = [];

  on(listener: (value: Value) => void): void {
    this.listeners.push(listener);
  }

  emit(value: Value): void {
    for (const listener of this.listeners) listener(value);
  }
}
