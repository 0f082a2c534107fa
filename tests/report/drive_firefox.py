"""Opens an example report in Firefox and uses it a little: drive_firefox.py FOLDER. Exit code 1 with the reasons if something is
wrong, 77 if there is no Firefox. Everything in detail: drive_page.py, in Chromium."""
import pathlib
import sys

from firefox import Firefox, find_firefox

failures = []


def expect(holds, claim):
    if not holds:
        failures.append(claim)


def picture(browser, index):
    """The viewer's picture once an image is drawn, as text that differs where pixels do."""
    browser.wait(f"document.getElementById('viewer').dataset.drawn === '{index}'", 30)
    return browser.evaluate("(ajar.drawNow(), document.getElementById('picture').toDataURL())")


def use(browser, url):
    browser.open(url)
    noisy = picture(browser, 1)
    browser.key("1")
    expect(picture(browser, 0) != noisy, "the reference looks like another image")
    browser.key("2")
    expect(picture(browser, 1) == noisy, "an image looks different after flipping there and back")
    browser.key("m")
    expect(browser.evaluate("ajar.state.map") == "absolute", "m shows no error map")
    expect(picture(browser, 1) != noisy, "the error map looks like the picture")
    browser.key("i")
    browser.wait("document.querySelectorAll('#insets canvas').length > 0", 10)
    browser.evaluate("document.getElementById('tab-results').click()")
    expect(browser.evaluate("document.querySelectorAll('#results .chart > svg .curve:not(.key *)').length") >= 9, "not every curve is drawn")
    for width, height in ((1440, 900), (500, 800)):
        browser.resize(width, height)
        overflow = browser.evaluate("document.documentElement.scrollWidth - innerWidth")
        expect(overflow <= 0, f"a window {width} pixels wide is {overflow} too narrow for the page")


def main():
    program = find_firefox()
    if program is None:
        print("there is no Firefox (AJAR_FIREFOX names another)")
        return 77
    url = (pathlib.Path(sys.argv[1]).resolve() / "index.html").as_uri()
    with Firefox(program) as browser:
        # Without a graphics card both may turn out to be the canvas.
        for renderer in ("canvas", "webgl"):
            use(browser, f"{url}?renderer={renderer}")
    print("\n".join(failures))
    return 1 if failures else 0


sys.exit(main())
