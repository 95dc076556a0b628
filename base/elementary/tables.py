#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes tables.h and tables.c of this folder: the constants and tables of the elementary functions.

All values are worked out with 100 decimal digits from textbook series and then cut into doubles. A number
that is needed to more than 53 bits is a head and a tail; heads have few enough bits that the products
they are used in are exact. tests/unit/run checks that the files are what this script writes.
"""
import sys
from decimal import Decimal, getcontext
from fractions import Fraction
from pathlib import Path

getcontext().prec = 100
HERE = Path(__file__).resolve().parent
TINY = Decimal(10) ** -95

EXP_STEPS = 128  # steps of 2^x in an octave
LOG_STEPS = 128  # steps of the logarithm in an octave
LOG_FIRST = 0x3FE6A00000000000  # bits of the first argument, 0.707
LOG_GRID = 43  # heads of logarithms are multiples of 2^-43
GRID = 64  # steps from 0 to 1 of the sine and of the arcs
SINE_LAST = 50  # pi/4 lies in this step
ARC_TERMS = 10  # the arcs: powers up to this one


def atan(x):
    """Euler's series, for 0 <= x <= 1."""
    square = x * x
    term = total = x / (1 + square)
    n = 1
    while term > TINY:
        term *= square / (1 + square) * (2 * n) / (2 * n + 1)
        total += term
        n += 1
    return total


def sine_cosine(x):
    terms = [Decimal(1)]
    while abs(terms[-1]) > TINY or len(terms) < 4:
        terms.append(terms[-1] * x / len(terms))
    sine = sum((t if i % 4 == 1 else -t) for i, t in enumerate(terms) if i % 2)
    cosine = sum((t if i % 4 == 0 else -t) for i, t in enumerate(terms) if i % 2 == 0)
    return sine, cosine


def asin(x):
    return atan(x / (1 - x * x).sqrt())


PI = 16 * atan(Decimal(1) / 5) - 4 * atan(Decimal(1) / 239)  # Machin
LN2 = Decimal(2).ln()


def decimal(fraction):
    return Decimal(fraction.numerator) / Decimal(fraction.denominator)


def on_grid(x, bits):
    """The nearest multiple of 2^-bits."""
    return float((x * 2**bits).to_integral_value()) / 2**bits


def head(x, bits):
    """x, cut to so many significant bits."""
    if x == 0:
        return 0.0
    size = 0
    while abs(x) * Decimal(2) ** -size >= 1:
        size += 1
    while abs(x) * Decimal(2) ** -size < Decimal("0.5"):
        size -= 1
    return float(int(x * Decimal(2) ** (bits - size))) * 2.0 ** (size - bits)


def parts(x, bits):
    """A head of so many bits and the rest."""
    first = head(x, bits)
    return [first, float(x - Decimal(first))]


def atan_terms(c):
    """Coefficients 2 ... ARC_TERMS of atan at c: the derivative is 1 / (1 + c^2 + 2 c d + d^2)."""
    slope = [1 / (1 + c * c)]
    for _ in range(ARC_TERMS - 1):
        before = slope[-2] if len(slope) > 1 else 0
        slope.append(-(2 * c * slope[-1] + before) / (1 + c * c))
    return slope[0], [s / (i + 1) for i, s in enumerate(slope)][1:]


def asin_terms(c):
    """Coefficients 2 ... ARC_TERMS of asin at c, from (1 - x^2) f'' = x f'."""
    room = 1 - c * c
    f = [asin(c), 1 / room.sqrt()]
    for n in range(ARC_TERMS - 1):
        f.append(((2 * n + 1) * (n + 1) * c * f[n + 1] + n * n * f[n]) / (room * (n + 1) * (n + 2)))
    return f[1], f[2:]


def exp_table():
    for i in range(EXP_STEPS):
        exact = (LN2 * i / EXP_STEPS).exp()
        value = float(exact)
        yield [value, float((exact - Decimal(value)) / Decimal(value))]


def log_table():
    for i in range(LOG_STEPS):
        bits = LOG_FIRST + (i << 45)
        centre = decimal(Fraction((bits & (2**52 - 1)) | 2**52, 2**52)) * Decimal(2) ** ((bits >> 52) - 1023)
        reciprocal = on_grid(1 / centre, 11)
        exact = -Decimal(reciprocal).ln()
        first = on_grid(exact, LOG_GRID)
        yield [reciprocal, first, float(exact - Decimal(first))]


def sine_table():
    for j in range(-SINE_LAST, SINE_LAST + 1):
        sine, cosine = sine_cosine(Decimal(j) / GRID)
        yield [parts(sine, 26), parts(cosine, 26), parts(-sine, 26)]


def arc_table(value, terms, last):
    for j in range(last + 1):
        c = Decimal(j) / GRID
        slope, rest = terms(c)
        yield parts(value(c), 53) + parts(slope, 26) + [float(t) for t in rest]


def words(x, count):
    """The first bits behind the point of x in [0, 1), 32 at a time."""
    getcontext().prec = 450
    bits = int(x() * 2 ** (32 * count))
    getcontext().prec = 100
    return [(bits >> (32 * (count - 1 - i))) & 0xFFFFFFFF for i in range(count)]


def two_over_pi():
    global TINY
    before, TINY = TINY, Decimal(10) ** -445
    value = 2 / (16 * atan(Decimal(1) / 5) - 4 * atan(Decimal(1) / 239))
    TINY = before
    return value


def constants():
    yield "LN2_HEAD", head(LN2, 42), "with 42 bits: times any exponent it is exact"
    yield "LN2_TAIL", float(LN2 - Decimal(head(LN2, 42))), ""
    step = LN2 / EXP_STEPS
    yield "STEPS_PER_UNIT", float(1 / step), "steps of the table of 2^x in an octave, over ln 2"
    yield "STEP_HEAD", head(step, 34), "ln 2 over the steps; with 34 bits"
    yield "STEP_TAIL", float(step - Decimal(head(step, 34))), ""
    tenth = 1 / Decimal(10).ln()
    yield "PER_LN10_HEAD", float(tenth), "1 / ln 10"
    yield "PER_LN10_TAIL", float(tenth - Decimal(float(tenth))), ""
    half = PI / 2
    yield "PER_HALF_PI", float(1 / half), "2 / pi"
    first = head(half, 33)
    second = head(half - Decimal(first), 33)
    yield "HALF_PI_FIRST", first, "pi / 2 in two pieces of 33 bits, and the rest"
    yield "HALF_PI_SECOND", second, ""
    yield "HALF_PI_THIRD", float(half - Decimal(first) - Decimal(second)), ""
    yield "HALF_PI_HEAD", float(half), "pi / 2 in two pieces"
    yield "HALF_PI_TAIL", float(half - Decimal(float(half))), ""


def definitions():
    """The constants as macros, aligned below each comment."""
    groups = []
    for name, value, why in constants():
        if why:
            groups.append((why, []))
        groups[-1][1].append((name, value))
    for why, group in groups:
        yield f"/* {why} */"
        width = max(len(name) for name, _ in group)
        yield from (f"#define {name:{width}} {value.hex()}" for name, value in group)


HEADER = """/* SPDX-License-Identifier: MIT */
/*
 * Constants and tables of the elementary functions. Written by tables.py.
 */
#ifndef LAMBERT_BASE_ELEMENTARY_TABLES_H
#define LAMBERT_BASE_ELEMENTARY_TABLES_H

#include <stdint.h>

enum {
	EXP_STEPS = %d,
	LOG_STEPS = %d,
	GRID = %d,
	SINE_LAST = %d,
	ASIN_LAST = %d,
	ARC_TERMS = %d,
	TWO_OVER_PI_WORDS = %d
};

%s

/* 2^(i / EXP_STEPS) is value (1 + tail). */
struct exp_step {
	double value, tail;
};
extern const struct exp_step exp_table[EXP_STEPS];

/* Bits of the first argument of the table of logarithms. */
#define LOG_FIRST UINT64_C(0x%x)
/* The reciprocal, of 12 bits, of about the middle of a step; minus its logarithm. */
struct log_step {
	double reciprocal, head, tail;
};
extern const struct log_step log_table[LOG_STEPS];

/* Sine, cosine and minus sine of j / GRID, each the derivative of the one before: heads with 26 bits, and
 * tails. The first is for -SINE_LAST. */
struct sine_step {
	double part[3][2];
};
extern const struct sine_step sine_table[2 * SINE_LAST + 1];

/* An arc function at j / GRID: its value; its slope, the head with 26 bits; the further terms of its
 * Taylor series. */
struct arc_step {
	double value, value_tail, slope, slope_tail, term[ARC_TERMS - 1];
};
extern const struct arc_step atan_table[GRID + 1];
extern const struct arc_step asin_table[ASIN_LAST + 1];

/* 2 / pi: its bits behind the point. */
extern const uint32_t two_over_pi[TWO_OVER_PI_WORDS];

#endif
"""


def fill(words):
    """Words in lines of at most 100 columns, the first with one tabulator less."""
    line, room = "\t", 100 - 8
    for word in words:
        if len(word) + 1 > room:
            yield line.rstrip()
            line, room = "\t\t", 100 - 16
        line += word + " "
        room -= len(word) + 1
    yield line.rstrip()


def rows(table, inner=None):
    """The rows of a table of structs; from the column inner on they are an array of their own."""
    for row in table:
        words = [x.hex() + "," for x in row]
        words[-1] = words[-1][:-1]
        if inner is not None:
            words[inner] = "{ " + words[inner]
            words[-1] += " }"
        yield from fill(["{", *words, "},"])


def sine_row(row):
    words = [word for head, tail in row for word in ("{ " + head.hex() + ",", tail.hex() + " },")]
    return fill(["{ {", *words[:-1], words[-1][:-1], "} },"])


def write():
    half = GRID // 2
    lines = "\n".join(definitions())
    pi_words = words(two_over_pi, 40)
    header = HEADER % (EXP_STEPS, LOG_STEPS, GRID, SINE_LAST, half, ARC_TERMS, len(pi_words), lines, LOG_FIRST)
    out = ["/* SPDX-License-Identifier: MIT */", "/*", " * Tables of the elementary functions. Written by tables.py.",
           " */", '#include "base/elementary/tables.h"', "", "/* clang-format off */", ""]

    def add(declaration, table, inner=None):
        out.extend([f"const {declaration} = {{", *rows(table, inner), "};", ""])

    add("struct exp_step exp_table[EXP_STEPS]", exp_table())
    add("struct log_step log_table[LOG_STEPS]", log_table())
    out.extend(["const struct sine_step sine_table[2 * SINE_LAST + 1] = {",
                *(line for row in sine_table() for line in sine_row(row)), "};", ""])
    add("struct arc_step atan_table[GRID + 1]", arc_table(atan, atan_terms, GRID), 4)
    add("struct arc_step asin_table[ASIN_LAST + 1]", arc_table(asin, asin_terms, half), 4)
    out.append("const uint32_t two_over_pi[TWO_OVER_PI_WORDS] = {")
    for i in range(0, len(pi_words), 6):
        out.append("\t" + " ".join(f"0x{w:08x}," for w in pi_words[i:i + 6]))
    out.append("};")
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    (folder / "tables.h").write_text(header)
    (folder / "tables.c").write_text("\n".join(out) + "\n")


if __name__ == "__main__":
    write()
