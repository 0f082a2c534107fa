"""Rows of names and values: as a table of pandas where that is there."""


class Rows(list):
    """Rows as dicts; `table` is the same for pandas, and notebooks show it."""

    @property
    def table(self):
        """A `pandas.DataFrame`; the rows themselves where pandas is not installed."""
        try:
            import pandas
        except ImportError:
            return self
        return pandas.DataFrame(list(self))

    def _repr_html_(self):
        from html import escape

        names = list(dict.fromkeys(name for row in self for name in row))

        def line(tag, cells):
            return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"

        def cell(value):
            return "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)

        body = "".join(line("td", [cell(row.get(name)) for name in names]) for row in self)
        return "<table>" + line("th", names) + body + "</table>"
