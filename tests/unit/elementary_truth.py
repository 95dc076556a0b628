#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes elementary_truth.def: arguments of the elementary functions and what is true there, to 100 digits,
as the nearest double and what is left, in units of its last place. Arguments are such as are hard (truth next to the middle of two
doubles, angles next to multiples of pi / 2 or huge, ends of ranges) and random ones of all sizes.
tests/unit/run checks that the file is what this script writes.
"""
import math
import random
import sys
from decimal import Decimal, getcontext
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parents[1] / "base" / "elementary"))
import tables  # noqa: E402

getcontext().prec = 450
tables.TINY = Decimal(10) ** -440
PI = 16 * tables.atan(Decimal(1) / 5) - 4 * tables.atan(Decimal(1) / 239)
PER_HALF_PI = 2 / PI
getcontext().prec = 120
tables.TINY = Decimal(10) ** -110


def sine_cosine(x):
    getcontext().prec = 450
    quarters = (x * PER_HALF_PI).to_integral_value()
    rest = x - quarters * PI / 2
    getcontext().prec = 120
    sine, cosine = tables.sine_cosine(+rest)
    return ((sine, cosine), (cosine, -sine), (-sine, -cosine), (-cosine, sine))[int(quarters) % 4]


def atan(x):
    if x < 0:
        return -atan(-x)
    if x > 1:
        return PI / 2 - atan(1 / x)
    if x > Decimal("0.3"):  # twice the angle of half of it: the series is then quick
        return 2 * atan(x / (1 + (1 + x * x).sqrt()))
    return tables.atan(x)


def asin(x):
    return PI / 2 * x if abs(x) == 1 else atan(x / (1 - x * x).sqrt())


def atan2(y, x):
    if x > 0:
        return atan(y / x)
    return atan(y / x) + (PI if y > 0 else -PI)


ONE = {
    "exp": lambda x: x.exp(),
    "log": lambda x: x.ln(),
    "log10": lambda x: x.log10(),
    "sin": lambda x: sine_cosine(x)[0],
    "cos": lambda x: sine_cosine(x)[1],
    "tan": lambda x: sine_cosine(x)[0] / sine_cosine(x)[1],
    "asin": asin,
    "acos": lambda x: PI / 2 - asin(x),
    "atan": atan,
    "sinh": lambda x: (x.exp() - (-x).exp()) / 2,
    "cosh": lambda x: (x.exp() + (-x).exp()) / 2,
    "tanh": lambda x: (x.exp() - (-x).exp()) / (x.exp() + (-x).exp()),
    "asinh": lambda x: ((x + (x * x + 1).sqrt()).ln() if x > 0 else -((-x + (x * x + 1).sqrt()).ln())),
    "acosh": lambda x: (x + (x * x - 1).sqrt()).ln(),
    "atanh": lambda x: ((1 + x) / (1 - x)).ln() / 2,
}
TWO = {"pow": lambda x, y: (y * x.ln()).exp(), "atan2": atan2}

# From long searches: the truth is next to the middle of two doubles.
HARD = """
acos -0x1.10f8886da7288p-1
acos -0x1.bee18d41d852p-1
acos 0x1.61f1fd3e27496p-1
acos 0x1.f2a0025ae7648p-3
acos 0x1.f6799bd16f18ap-1
acos 0x1.fde0f5fc6cb25p-1
acos 0x1.fe24e4b505f3dp-1
acos 0x1.ff621117e2416p-1
acosh 0x1.33b557edc71cdp+0
acosh 0x1.4badf32fb8a2cp+0
acosh 0x1.586057b634eap+426
acosh 0x1.63b29d2c8859ep+604
acosh 0x1.c36d052b8cb54p+0
acosh 0x1.c3fbb95393955p+0
asin -0x1.1865593880c48p-2
asin -0x1.dcd68d87e066ap-1
asin -0x1.ec78fa15afdap-3
asin 0x1.4e8e47d94688ap-1
asin 0x1.8542cc6a40a9fp-23
asinh -0x1.42cd9c73ead4p-5
asinh -0x1.dc0c7457eadbcp+625
asinh 0x1.09e9dfd3c6666p+772
asinh 0x1.1a1ab17ec111p-4
asinh 0x1.3507c246a94c8p-1
asinh 0x1.48287b5878ee2p-1
asinh 0x1.731062a4ea6c2p-1
asinh 0x1.d979ef5bd8948p-2
atan -0x1.2e4046618f234p-1
atan -0x1.96004f80bd62p+2
atan 0x1.4b315c9697e88p+2
atan 0x1.72c5f5b3a96c4p-2
atan 0x1.8e8e6ad1481b2p-1
atan 0x1.b151a2aa6864p-2
atan 0x1.b3a181a40d9f4p-1
atan 0x1.bc04b6eb198dp-1
atanh -0x1.0d99402c7ad89p-16
atanh -0x1.781bffa9c03b8p-2
atanh -0x1.a6dfabe5aaf97p-18
atanh -0x1.b183d0d9f1c8p-3
atanh 0x1.6556a57fcaf8ap-1
atanh 0x1.a6a58dfbf514p-26
cos -0x1.2fea1542d93cap-1
cos -0x1.71bc6cc450feap-1
cos -0x1.8af5ab05939f2p-1
cos 0x1.12d80e7255b7ep-1
cos 0x1.1a74d9207a64p-2
cos 0x1.1bfad8d506868p-3
cos 0x1.f17841d85b938p-2
cos 0x1.ffb8e88b6af64p-1
cosh -0x1.11a032b7ca9ep-2
cosh -0x1.7186111b44eb8p-2
exp -0x1.632c9a39a4183p+9
exp -0x1.6aa04ad83a9cfp+9
exp -0x1.6c05a31ffce1p+9
exp -0x1.73366bf05960bp+9
exp -0x1.a7c4560535a5bp+8
exp 0x1.2f3a6913cb69p+5
exp 0x1.a690dcb8c93dcp+7
exp 0x1.bed86e9f5658cp-2
log 0x1.0318f88f3253p+0
log 0x1.0b934521a6af8p+0
log 0x1.1a7608c20c468p+0
log 0x1.412216ab0da66p-18
log 0x1.e66374866101ap-1
log 0x1.f84e646071df2p-1
log 0x1.f9329ff92e869p-1
log10 0x1.51d3199004ae9p-829
log10 0x1.8ac3ec9d87e14p-1
log10 0x1.b7efe44e4dedp+0
log10 0x1.d22e7ac933a7dp-1
log10 0x1.e858481670b7dp+898
log10 0x1.e94caa3d48496p-1
pow 0x1.000417e2fee7bp+0 0x1.fc269d67d66f8p+2
pow 0x1.0d71eb673ebe7p+0 -0x1.c29fac2326043p+4
pow 0x1.192279ef5b027p+0 -0x1.9cb270e0636aep+2
pow 0x1.1c968dcbe9efbp-6 0x1.af8ce3a031868p+3
pow 0x1.5ef5b192c23a2p-4 0x1.71f5d9716445cp+5
pow 0x1.d4c729e20c766p+0 0x1.4b823ee9046bp+0
pow 0x1.eb0e192d14891p-1 -0x1.49b655a33ab1p-1
pow 0x1.ef835d3a26051p+59 0x1.8420abf0e4364p-2
sin -0x1.04af7beb95233p+6
sin -0x1.45aa4e7cdade4p-12
sin -0x1.89a5061c95b9cp-21
sin -0x1.dc0a1978d088p-1
sin 0x1.27038b2085997p-7
sin 0x1.36d62d7d414fcp+5
sin 0x1.50b68104b19c4p+6
sin 0x1.df5238fe7a066p-1
sinh -0x1.25792aad4a39ap-9
sinh -0x1.26bfdd7611ce3p-9
sinh -0x1.3209558a6b6c4p-2
sinh -0x1.458784fef5336p-4
sinh -0x1.a7b050a45d44p+6
sinh 0x1.4881c64eebe0cp+8
sinh 0x1.b90bbb8bf271cp-2
sinh 0x1.cfe7a99642224p-14
tan -0x1.2093a4ddff79ap+5
tan -0x1.32ab19aeb122p+6
tan -0x1.91f4608457a4p-1
tan -0x1.996b9755c02ap-1
tan 0x1.1fa789a956d5cp-1
tan 0x1.3d64980c19e72p-1
tan 0x1.7032a65f6b234p-1
tan 0x1.b82e8009e97fp+3
tanh -0x1.06182c0b7eb54p+4
tanh -0x1.3a9ef81604a8p-3
tanh -0x1.c6cdd8710007ap-2
tanh 0x1.12880dbaf3446p+4
tanh 0x1.4c80fb26673bp+0
tanh 0x1.b3ac3fa3eaa5cp-1
tanh 0x1.b524b2b4418fp+1
tanh 0x1.c0a1b8f0c310ep-1
"""


def hexes(text):
    return [float.fromhex(word) for word in text.split()]


def around(x):
    return [math.nextafter(x, -math.inf), x, math.nextafter(x, math.inf)]


def spread(source, least, largest, count):
    """Random numbers of all sizes, without the logarithms of this machine."""
    a, b = math.frexp(least)[1], math.frexp(largest)[1] - 2
    return [math.ldexp(source.uniform(1, 2) * source.choice((1, -1)), source.randint(a, b)) for _ in range(count)]


def arguments(name, source):
    angles = [float(PI / 2 * k) for k in (1, 2, 3, 4, 5, 7, 8, 16, 100, 355, 1000, 123456, 10**6, 10**7, 10**12)]
    # The double nearest to a multiple of pi / 2, relative to its size, and others of huge size.
    angles += hexes("0x1.6ac5b262ca1ffp+849 0x1.fffffffffffffp+1023 0x1p+1000 0x1.6a09e667f3bcdp+500 0x1p20 0x1p21")
    angles += [-x for x in angles[:6]] + spread(source, 1e-12, 1e22, 40) + spread(source, 1e22, 1e308, 20)
    angles += [source.uniform(-10, 10) for _ in range(40)]
    unit = [source.uniform(-1, 1) for _ in range(60)] + spread(source, 1e-14, 1, 40)
    unit += [1 - abs(x) for x in spread(source, 1e-15, 0.5, 30)] + [0.5, -0.5, *around(0.5)] + around(1.0)[:1]
    growing = spread(source, 1e-12, 700, 60) + [source.uniform(-5, 5) for _ in range(60)] + around(709.5)
    positive = [abs(x) for x in spread(source, 1e-300, 1e300, 50)] + [source.uniform(0.5, 2) for _ in range(50)]
    positive += [1 + x for x in spread(source, 1e-15, 0.1, 40)] + hexes("0x1p-1074 0x1.8p-1040 0x1.fffffffffffffp+1023")
    if name in ("sin", "cos", "tan"):
        return angles
    if name in ("asin", "acos", "atanh"):
        return unit
    if name in ("log", "log10"):
        return positive
    if name == "acosh":
        return [x for x in positive if x > 1] + [1 + abs(x) for x in spread(source, 1e-14, 10, 60)]
    if name in ("exp", "sinh", "cosh", "tanh"):
        more = [source.uniform(-745, -700) for _ in range(30)] if name == "exp" else []
        return growing + more
    return spread(source, 1e-14, 1e20, 60) + [source.uniform(-3, 3) for _ in range(60)]


def pairs(name, source):
    if name == "atan2":
        near = [(source.uniform(-1, 1), source.uniform(-1, 1)) for _ in range(80)]
        return near + list(zip(spread(source, 1e-300, 1e300, 30), spread(source, 1e-300, 1e300, 30)))
    near = [(source.uniform(0, 3), source.uniform(-20, 20)) for _ in range(80)]
    near += [(1 + x, y) for x, y in zip(spread(source, 1e-14, 0.1, 30), spread(source, 1, 1000, 30))]
    for x in spread(source, 1e-300, 1e300, 60):  # results of all sizes, subnormal ones too
        near.append((abs(x), float(Decimal(source.uniform(-742, 709)) / Decimal(abs(x)).ln())))
    return near


def line(kind, name, values, truth):
    high = float(truth)
    low = float((truth - Decimal(high)) / Decimal(math.ulp(high)))
    return f"{kind}({name}, {', '.join(x.hex() for x in (*values, high, low))})"


def main():
    out = ["/* SPDX-License-Identifier: MIT */",
           "/* Arguments of functions, the nearest double to the true result, and what is left, in units of",
           " * its last place. Written by elementary_truth.py. */"]
    hard = [text.split() for text in HARD.strip().splitlines()]
    for name, function in ONE.items():
        source = random.Random(name)
        some = [float.fromhex(words[1]) for words in hard if words[0] == name]
        for x in some + arguments(name, source):
            truth = function(Decimal(x))
            if abs(truth) < Decimal(sys.float_info.max):
                out.append(line("ONE", name, (x,), truth))
    for name, function in TWO.items():
        source = random.Random(name)
        some = [(float.fromhex(words[1]), float.fromhex(words[2])) for words in hard if words[0] == name]
        for x, y in some + pairs(name, source):
            truth = function(Decimal(x), Decimal(y))
            if abs(truth) < Decimal(sys.float_info.max):
                out.append(line("TWO", name, (x, y), truth))
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    (folder / "elementary_truth.def").write_text("\n".join(out) + "\n")


main()
