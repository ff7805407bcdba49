"""Would shorter kinds of tables be cheaper? Plain, bipartite (Das Sarma and Matula 1995) and linearly interpolated tables of the functions
that the designs read, each with its adders, multiplier and registers, at equal worst error, by the shipped price table. Arithmetic on words,
no netlists: it decides what is worth building. For better_designs.py."""

import math
import pathlib
import tomllib

PRICES = tomllib.loads((pathlib.Path(__file__).resolve().parent.parent / "testbench/prices/osu018_model.toml").read_text())["area"]
GUARD = 2

FUNCTIONS = {
    "cos, a quarter turn": (lambda x: math.cos(math.pi / 2 * x), 0, 1),
    "-log2 cos, a quarter turn, below 4": (lambda x: min(4.0, -math.log2(max(1e-9, math.cos(math.pi / 2 * x)))), 0, 4),
    "-log2 hav, half a turn, below 8": (lambda x: min(8.0, -2 * math.log2(max(1e-9, math.sin(math.pi / 2 * x)))), 0, 8),
    "2^-x": (lambda x: 2.0**-x, 0.5, 1),
    "0.3 x^20": (lambda x: 0.3 * x**20, 0, 1),
}


def linear(component, **sizes):
    return PRICES[component].get("base", 0) + sum(PRICES[component].get(f"per_{size}", 0) * value for size, value in sizes.items())


def adder(width):
    return linear("adder", width=width)


def multiplier(first, second):
    return PRICES["multiplier"]["coefficient"] * first * second


def registers(bits):
    return PRICES["register"]["value"] * bits


def table(words):
    """Area of a ROM of whole numbers >= 0."""
    width = max(1, max(words).bit_length())
    changes = sum(bin(a ^ b).count("1") for a, b in zip(words, words[1:]))
    if changes == 0:
        return 0.0
    sizes = {"entries": len(words), "word": width, "columns": 1, "changes": changes}
    entry, price = PRICES["table"], PRICES["table"]["coefficient"]
    for size, value in sizes.items():
        price *= value ** entry.get(f"exponent_{size}", 0)
    return price


def centre(code, bits, shared):
    """Middle of the codes of `bits` bits that share their bits above the lowest `shared`; a code alone stands for its middle."""
    return ((code << shared) + 2 ** (shared - 1) if shared else code + 0.5) / 2**bits


def exact(function, bits):
    return [function((code + 0.5) / 2**bits) for code in range(2**bits)]


def plain(function, index_bits, bits, step):
    shared = index_bits - bits
    words = [round(function(centre(code, index_bits, shared)) / step) for code in range(2**bits)]
    wanted = exact(function, index_bits)
    error = max(abs(words[code >> shared] * step - value) for code, value in enumerate(wanted))
    return table(words), error, (max(words).bit_length()) * len(words)


def bipartite(function, index_bits, split, step, most_error):
    """(area, bits), or nothing if it errs more. An index is three fields; the first table takes the upper two, the second the first and
    the last, along the mean slope of the first."""
    n0, n1, n2 = split
    fine = step / 2**GUARD

    def at(a, b, c):
        return function((((a << n1 | b) << n2) + c + 0.5) / 2**index_bits)

    middle = 2**n2 // 2
    first = [round(at(a, b, middle) / fine) for a in range(2**n0) for b in range(2**n1)]
    offsets = [round(sum(at(a, b, c) - at(a, b, middle) for b in range(2**n1)) / 2**n1 / fine) for a in range(2**n0) for c in range(2**n2)]
    error = 0.0
    for a in range(2**n0):
        for b in range(2**n1):
            for c in range(2**n2):
                value = (first[a << n1 | b] + offsets[a << n2 | c] + 2 ** (GUARD - 1)) >> GUARD
                error = max(error, abs(value * step - at(a, b, c)))
        if error > most_error:
            return None
    width, low = max(first).bit_length(), max(offset.bit_length() for offset in offsets) + 1
    offsets = [offset % 2**low for offset in offsets]
    return table(first) + table(offsets) + adder(width) + registers(width + low), width * len(first) + low * len(offsets)


def interpolated(function, index_bits, bits, step, most_error):
    """(area, bits) of value + slope * rest, or nothing if it errs more."""
    rest_bits = index_bits - bits
    fine = step / 2**GUARD
    base = [round(function(code / 2**bits) / fine) for code in range(2**bits)]
    slope = [round((function((code + 1) / 2**bits) - function(code / 2**bits)) / fine) for code in range(2**bits)]
    error = 0.0
    for code in range(2**index_bits):
        part, rest = code >> rest_bits, code & 2**rest_bits - 1
        value = (base[part] + ((slope[part] * (2 * rest + 1)) >> (rest_bits + 1)) + 2 ** (GUARD - 1)) >> GUARD
        error = max(error, abs(value * step - function((code + 0.5) / 2**index_bits)))
        if error > most_error:
            return None
    width, steep = max(1, max(base).bit_length()), max(value.bit_length() for value in slope) + 1
    words = [value % 2**steep for value in slope]
    state = width + steep + rest_bits + width + steep  # in front of the multiplier and behind it
    return table(base) + table(words) + multiplier(steep, rest_bits) + adder(width) + registers(state), (width + steep) * len(base)


def best(candidates):
    return min((c for c in candidates if c is not None), default=None)


def light_tables(widths):
    """DIFF (kd = 0.75) and SPEC (ks = 0.3, n = 20), both."""
    bits, step = widths["light_table_bits"], 2.0 ** (1 - widths["light_word_bits"])
    return sum(plain(f, bits, bits, step)[0] for f in (lambda x: 0.75 * x, lambda x: 0.3 * x**20))


def log_cosine(widths):
    function, _, _ = FUNCTIONS["-log2 cos, a quarter turn, below 4"]
    bits = widths["log_table_bits"]
    return plain(function, bits, bits, 2.0 ** -widths["log_bits"])[0]


def report():
    print("## Bipartite and interpolated tables\n")
    print("The functions that the designs read, as plain tables of 2^k words, as two tables and an adder (bipartite, Das Sarma and Matula 1995), and as value, slope and a short multiplier; each at most as wrong as the plain table whose step is 2^-(k+2), at every "
          "code of an index of two bits more (worst error), the best split. Area in NAND2 with adder, multiplier and the registers that their cycles take, table bits in brackets. Computed by `scripts/table_study.py` from the words themselves and the shipped prices.\n")
    print("| function | k | plain | bipartite | interpolated | smallest |")
    print("|--|--:|--:|--:|--:|--|")
    wins, fewer = {}, []
    for label, (function, _, top) in FUNCTIONS.items():
        for k in range(4, 11):
            step, index = 2.0 ** -(k + 2), k + 2
            area, error, bits = plain(function, index, k, step)
            two = best(bipartite(function, index, (n0, index - n0 - n2, n2), step, error) for n0 in range(1, index - 1) for n2 in range(1, index - n0))
            line = best(interpolated(function, index, s, step, error) for s in range(1, index))
            kinds = {"plain": area, "bipartite": two and two[0], "interpolated": line and line[0]}
            winner = min((kind for kind in kinds if kinds[kind] is not None), key=lambda kind: kinds[kind])
            wins.setdefault(winner, []).append((k, area / kinds[winner]))
            if two and two[1] < bits and label.startswith("cos"):
                fewer.append(k)
            cell = lambda pair: "-" if pair is None else f"{pair[0]:.0f} ({pair[1]})"
            print(f"| {label} | {k} | {area:.0f} ({bits}) | {cell(two)} | {cell(line)} | {winner} |")
    plain_wins, rows = wins.get("plain", []), sum(map(len, wins.values()))
    others = sorted((k, kind) for kind in ("bipartite", "interpolated") for k, _ in wins.get(kind, []))
    print()
    text = f"Plain tables are the smallest in {len(plain_wins)} of {rows} rows"
    if others:
        text += f"; the first that is not has 2^{others[0][0]} words ({others[0][1]})"
    print(text + ". This project's designs above read tables of 2^3 to 2^8 words, so neither kind is an option of theirs. This holds for tables made of gates, "
          "whose area grows slower than their bits. Where a table is a memory that is paid by the bit, the bits in brackets count"
          + (f": a bipartite cosine has fewer from k = {min(fewer)} on" if fewer else "") + ".\n")
    eighth()


def eighth():
    print("## Half the quarter wave\n")
    print("Where sine and cosine are read together, an eighth of a turn holds both: half the words, a reflection of the address and two multiplexers more. The logarithms of both, as `lns` reads them:\n")
    print("| k | quarter turn, two columns | eighth | saved by each read |")
    print("|--:|--:|--:|--:|")
    for k in range(4, 9):
        step, width = 2.0 ** -(k + 1), k + 4  # three bits before the point
        logs = [[min(2**width - 1, round(-math.log2(f(math.pi / 2 * (code + 0.5) / 2**k)) / step)) for code in range(2**k)] for f in (math.sin, math.cos)]
        joined = [sine << width | cosine for sine, cosine in zip(*logs)]
        half = joined[: len(joined) // 2]
        whole_area = table(joined)
        half_area = table(half) + linear("negate", width=k - 1) + 2 * linear("select", width=width)
        print(f"| {k} | {whole_area:.0f} | {half_area:.0f} | {whole_area - half_area:.0f} |")
    print("\nIt pays from the row on whose last column is positive, little at the sizes that `lns` has below 48 dB (k = 5, 6), and nothing in `tl0` and `tl2`, which read cosines alone.\n")


if __name__ == "__main__":
    report()
