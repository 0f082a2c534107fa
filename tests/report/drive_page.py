"""Uses an example report as a reader would: drive_page.py FOLDER. Exit code 1 with the reasons if something is wrong, 77 if
there is no browser."""
import pathlib
import sys

from browser import Browser, find_chromium

failures = []


def expect(holds, claim):
    if not holds:
        failures.append(claim)


def wait_for_image(browser, index):
    browser.wait(f"document.getElementById('viewer').dataset.drawn === '{index}'", 10)


def picture(browser):
    """The viewer's picture, as text that differs where pixels do."""
    return browser.evaluate("(ajar.drawNow(), document.getElementById('picture').toDataURL())")


def flips(browser):
    wait_for_image(browser, 1)
    noisy = picture(browser)
    browser.key("1", "Digit1")
    wait_for_image(browser, 0)
    expect(picture(browser) != noisy, "the reference looks like another image")
    browser.key("ArrowRight", "ArrowRight")
    wait_for_image(browser, 1)
    expect(picture(browser) == noisy, "an image looks different after flipping there and back")
    browser.key(" ", "Space")
    wait_for_image(browser, 0)
    browser.key(" ", "Space")
    wait_for_image(browser, 1)


def zooms(browser):
    before = browser.evaluate("ajar.view().zoom")
    x, y = browser.middle("#viewer")
    browser.wheel(x, y, -240)
    expect(abs(browser.evaluate("ajar.view().zoom") / before - 2) < 0.01, "a step of the wheel does not zoom by 2")
    browser.drag((x, y), (x + 60, y))
    expect(browser.evaluate("ajar.state.x") < 160, "dragging to the right does not show what is left")
    browser.key("f")
    expect(browser.evaluate("ajar.view().zoom") == before, "f does not fit the picture")


def shows_errors(browser):
    colour = picture(browser)
    browser.key("m")
    wait_for_image(browser, 1)
    expect(browser.evaluate("ajar.state.map") == "absolute", "m shows no error map")
    expect(picture(browser) != colour, "the error map looks like the picture")
    expect(not browser.evaluate("document.getElementById('legend').hidden"), "the error map has no legend")
    # An image equal to the reference has no error: one colour everywhere.
    colours = browser.evaluate(
        "(() => { const {images} = ajar.data; const [a, r] = [images[4], images[0]].map((one) => ajar.pixels.get(one, ''));"
        "return a && r ? ajar.errorAt(a, r, 5000, 'absolute') : 'not loaded'; })()")
    expect(colours in (0, "not loaded"), f"an image equal to the reference has the error {colours}")
    browser.key("r")
    expect(browser.evaluate("ajar.state.map") == "colour", "r does not leave the error map")


def shows_insets(browser):
    browser.key("i")
    browser.wait("document.querySelectorAll('#insets canvas').length > 0", 5)
    browser.wait("![...document.querySelectorAll('.inset-caption')].some((one) => one.textContent.startsWith('loading'))", 10)
    count = browser.evaluate("document.querySelectorAll('#insets .inset-column').length")
    expect(count == browser.evaluate("ajar.data.images.length"), f"{count} images have insets")
    caption = browser.evaluate("document.querySelector('[data-image=\"1\"] .inset-caption').textContent")
    expect(caption.startswith("relMSE "), f"an inset's caption is {caption!r}")
    browser.key("i")


def shows_texts_literally(browser):
    for hostile in ("img[src='x']", "#metadata script", "svg[onload]", "#title b"):
        expect(browser.evaluate(f"document.querySelector(\"{hostile}\") === null"), f"{hostile} became an element")


def shows_results(browser):
    browser.click("#tab-results")
    expect(browser.evaluate("document.querySelectorAll('#results .chart > svg .curve:not(.key *)').length") == 9, "not every curve is drawn")
    titles = browser.evaluate("[...document.querySelectorAll('#results .chart > svg')].map((one) => [...one.querySelectorAll('.axis-title')].map((text) => text.textContent).join(' ')).join(', ')")
    expect(titles == "seconds relMSE, seconds MAE, sigma PSNR", f"the axes of the charts are {titles}")
    ticks = browser.evaluate("Math.min(...[...document.querySelectorAll('#results .chart > svg')].map((one) => one.querySelectorAll('.tick').length))")
    expect(ticks >= 6, f"a chart has {ticks} ticks")
    expect(browser.evaluate("document.querySelectorAll('#results table').length") >= 2, "tables are missing")


def reads_and_hides_curves(browser):
    """The first plot: pt from 0.5 to 97.3 seconds, and others."""
    row = "[...document.querySelector('.readout tbody').rows].find((one) => one.cells[0].textContent.trim() === 'pt')"
    cells = f"[...{row}.cells].slice(1).map((one) => one.textContent).join(' ')"
    at_end = browser.evaluate(cells)
    expect(at_end == "97.3 0.01316 0.0114 … 0.0151", f"at the end pt reads {at_end}")
    browser.evaluate("document.querySelector('.chart').scrollIntoView()")
    browser.move(*browser.middle(".chart > svg .series:last-child [data-point]"))
    browser.settle()
    expect(browser.evaluate(cells).startswith("0.500 1.6"), f"at the start pt reads {browser.evaluate(cells)}")
    expect(browser.evaluate("document.querySelectorAll('.mark.at').length") == 5, "a point that is read is not marked")
    browser.move(1, 1)
    browser.settle()
    expect(browser.evaluate(cells) == at_end, "away from the plot its end is not read")
    # As from the keyboard.
    browser.evaluate(f"{row}.querySelector('input').focus()")
    browser.key(" ", "Space")
    hidden = browser.evaluate("[...document.querySelectorAll('.off')].map((one) => getComputedStyle(one).display).join(' ')")
    expect(hidden == "none none", f"a curve and its band without a tick display as {hidden!r}")
    expect(browser.evaluate(cells) == "– – –", "a hidden curve is read")
    browser.key(" ", "Space")
    expect(browser.evaluate("document.querySelectorAll('.off').length") == 0, "a curve does not come back")


def shows_plots_without_scripts(browser, url):
    browser.call("Emulation.setScriptExecutionDisabled", value=True)
    browser.call("Page.navigate", url=url)
    browser.wait("document.readyState === 'complete' && [...document.querySelectorAll('.chart > svg')].filter((one) => one.getBoundingClientRect().width > 300).length === 3", 10)
    browser.call("Emulation.setScriptExecutionDisabled", value=False)


def fits_narrow_windows(browser):
    for width in (420, 1024, 1440):
        browser.resize(width, 800)
        for tab in ("images", "results"):
            browser.click(f"#tab-{tab}")
            overflow = browser.evaluate(
                f"Math.max(...[document.documentElement, document.getElementById('{tab}')].map((one) => one.scrollWidth - one.clientWidth))")
            expect(overflow <= 0, f"{tab} are {overflow} pixels too wide for a window of {width}")
    browser.resize(1440, 900)


def shows_whole_tables(browser):
    """Also the widest there is, a study's of all metrics; what is cut off is its efficiency."""
    browser.resize(1440, 900)
    browser.click("#tab-results")
    for title, overflow in browser.evaluate(
            "[...document.querySelectorAll('#results .scroll')].map((one) =>"
            "[one.closest('section').querySelector('h2').textContent, one.scrollWidth - one.clientWidth])"):
        expect(overflow <= 0, f"the table {title!r} is {overflow} pixels too wide for a window of 1440")
    widest = browser.evaluate("Math.max(...[...document.querySelectorAll('#results thead tr')].map((one) => one.cells.length))")
    expect(widest == 19, f"the widest table has {widest} columns")
    expect(browser.evaluate("document.querySelectorAll('#results .dense td:not(.number)').length") == 0,
           "a number of a study is not set to the right")


def shows_help(browser):
    browser.key("?")
    expect(browser.evaluate("document.getElementById('help').open"), "? opens no help")
    browser.key("Escape", "Escape")
    expect(not browser.evaluate("document.getElementById('help').open"), "Escape does not close the help")


def main():
    program = find_chromium()
    if program is None:
        print("there is no Chromium (AJAR_CHROMIUM names another)")
        return 77
    url = (pathlib.Path(sys.argv[1]).resolve() / "index.html").as_uri()
    with Browser(program) as browser:
        # A machine without graphics card would choose the other renderer.
        browser.open(url + "?renderer=webgl")
        expect(browser.evaluate("ajar.renderer.name") != "2D canvas", "WebGL is not used")
        for part in (flips, zooms, shows_errors, shows_insets, shows_help, shows_texts_literally, shows_results, reads_and_hides_curves, shows_whole_tables, fits_narrow_windows):
            part(browser)
        # What a link says is what its reader sees; without WebGL too.
        browser.open(url + "?renderer=canvas#a=3&map=smape")
        wait_for_image(browser, 2)
        expect(browser.evaluate("ajar.renderer.name") == "2D canvas", "the link's renderer is not used")
        expect(browser.evaluate("ajar.state.map") == "smape", "the link's error map is not shown")
        shows_plots_without_scripts(browser, url)
        failures.extend("the page reports: " + error for error in browser.errors)
    print("\n".join(failures))
    return 1 if failures else 0


sys.exit(main())
