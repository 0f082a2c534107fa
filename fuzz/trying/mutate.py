"""Scene texts, changed as a careless or hostile hand would."""
import re

NUMBERS = ["0", "-1", "-0", "1e-45", "1e-30", "1e-7", "1e7", "1e18", "1e19", "1e30", "3.4e38", "1e39", "1e309",
           "nan", "inf", "-inf", "2147483647", "2147483648", "-2147483649", "0x10", "1e", "--1", "65536", "1000000"]
FILES = ['"/dev/zero"', '"/dev/stdin"', '"/dev/tty"', '"pipe"', '"."', '""', '"missing.ply"', '"self.pbrt"',
         '"\x1b[31mred"', '"' + "n" * 300 + '"', '"scene.pbrt"']
TOKEN = re.compile(r'"(?:[^"\\\n]|\\.)*"|\[|\]|[-+.\w]+|#[^\n]*', re.ASCII)
NUMBER = re.compile(r"[-+]?\d*\.?\d+(?:[eE][-+]?\d+)?$")
NAME = re.compile(r'"[a-zA-Z][\w ]*"$')


def _number(rng, text, spots):
    begin, end = rng.choice(spots)
    return text[:begin] + rng.choice(NUMBERS) + text[end:]


def _scaled(rng, text, spots):
    begin, end = rng.choice(spots)
    try:
        return text[:begin] + repr(float(text[begin:end]) * 10.0 ** rng.randint(-40, 40)) + text[end:]
    except (ValueError, OverflowError):
        return text


def _letter(rng, text, spots):
    begin, end = rng.choice(spots)
    at = rng.randrange(begin, end)
    return text[:at] + rng.choice("abcxyz \x00\x1b\xff\n") + text[at + 1:]


def _file(rng, text, spots):
    begin, end = rng.choice(spots)
    return text[:begin] + rng.choice(FILES) + text[end:]


def _delete(rng, text, spots):
    begin, end = rng.choice(spots)
    return text[:begin] + text[end:]


def _swap(rng, text, spots):
    a, b = sorted(rng.sample(spots, 2)) if len(spots) > 1 else (spots[0], spots[0])
    if a[1] > b[0]:
        return text
    return text[:a[0]] + text[b[0]:b[1]] + text[a[1]:b[0]] + text[a[0]:a[1]] + text[b[1]:]


def _repeat_lines(rng, text, _spots):
    lines = text.splitlines(True)
    begin = rng.randrange(len(lines))
    some = lines[begin:begin + rng.randint(1, 5)]
    at = rng.randrange(len(lines))
    return "".join(lines[:at] + some * rng.choice([1, 1, 2, 50]) + lines[at:])


def _cut(rng, text, _spots):
    return text[:rng.randrange(len(text))]


def mutate(rng, text):
    """A few changes, one after the other."""
    for _ in range(rng.choice([1, 1, 1, 2, 3, 8])):
        tokens = [m.span() for m in TOKEN.finditer(text) if not m.group().startswith("#")]
        if not tokens:
            return text
        numbers = [s for s in tokens if NUMBER.match(text[s[0]:s[1]])] or tokens
        names = [s for s in tokens if NAME.match(text[s[0]:s[1]])] or tokens
        change, spots = rng.choice([(_number, numbers), (_number, numbers), (_scaled, numbers), (_letter, names),
                                    (_file, names), (_delete, tokens), (_swap, tokens), (_repeat_lines, tokens),
                                    (_cut, tokens)])
        text = change(rng, text, spots)
    return text
