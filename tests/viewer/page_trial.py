"""A person at the page of `ajar view`, in a headless Chromium."""


class PageTrial:
    """`pictures`: folder for screenshots, or None."""

    def __init__(self, browser, pictures):
        self.browser, self.pictures = browser, pictures

    def picture(self, name):
        if self.pictures:
            self.browser.settle()
            self.browser.screenshot(self.pictures / f"{name}.png")

    def place(self, x, y):
        """Where a pixel of the picture is in the window."""
        point = self.browser.evaluate(f"ajarView.place({x}, {y})")
        return point["x"], point["y"]

    def pixel(self, x, y):
        """The colour on the screen of a pixel of the picture."""
        return self.browser.evaluate(f"ajarView.pixel({x}, {y})")

    def focus(self):
        self.browser.evaluate("document.getElementById('viewer').focus()")

    def tool(self, name):
        self.focus()
        if self.browser.evaluate("document.getElementById('viewer').dataset.tool") != name:
            self.browser.click(f"#tool-{name}")
