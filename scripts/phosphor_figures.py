"""What is known of phosphors, and from where: the figures that scripts/fit_phosphors fits laws to.

Times are microseconds, colours CIE 1931 xy, luminances at 10 kV with P31 = 100 (Tektronix, reference
table, revision C, 1966).
"""

TEKTRONIX = ("Tektronix CRT Data, phosphor decay table, revision A, 1966, read as decay after continuous "
             "excitation.")
BY_MEMORY = "Colour: the JEDEC register's as quoted from memory, not verified."
CANDIDATE = "Colour: a candidate not verified."

# Name; what it is; CIE 1931 xy; time from the end of continuous excitation to 10 %, 1 % and 0.1 %, us;
# luminance at 10 kV, P31 = 100 (Tektronix, reference table, revision C, 1966); a note.
ONE_LAYER = [
    ("P1", "green, medium", (0.218, 0.712), (27e3, 60e3, 95e3), 45, "Colour: Tektronix."),
    ("P3", "yellowish orange, medium", (0.523, 0.469), (19e3, 45e3, 74e3), 45, "Colour: Tektronix."),
    ("P4", "white of television", (0.265, 0.285), (320, 3300, 20e3), 50,
     "A mixture of two sulphides. Colour: Tektronix."),
    ("P5", "blue, short", (0.169, 0.132), (21, 45, 104), 3, BY_MEMORY),
    ("P6", "white", (0.338, 0.374), (330, 3300, 18e3), None, "A mixture. " + BY_MEMORY),
    ("P11", "blue, photographed", (0.139, 0.148), (274, 2600, 17e3), 25, BY_MEMORY),
    ("P15", "bluish green, very short", (0.246, 0.439), (2, 12, 50), 15, BY_MEMORY),
    ("P16", "violet, very short", (0.175, 0.003), (1.1, 75, None), None,
     "The table does not give its tail: it is left to end with the longest term. " + BY_MEMORY),
    ("P18", "white", (0.333, 0.347), (380, 16e3, 50e3), None, "A mixture. " + BY_MEMORY),
    ("P20", "yellowish green", (0.426, 0.546), (230, 2300, 11e3), 85, BY_MEMORY),
    ("P23", "warm white", (0.364, 0.377), (325, 3600, 22e3), 80, "A mixture. " + BY_MEMORY),
    ("P24", "bluish green, short", (0.245, 0.441), (18, 137, 590), 8, BY_MEMORY),
    ("P28", "yellowish green, long", (0.370, 0.540), (390, 17e3, 132.5e3), 50, BY_MEMORY),
    ("P31", "green of oscilloscopes", (0.226, 0.528), (340, 4500, 32e3), 100, CANDIDATE),
    ("P35", "bluish white", (0.286, 0.420), (250, 2800, 21e3), 55, BY_MEMORY),
]

# Two layers. How much of the luminance each gives is in no table: the flash layer is taken for a screen of
# the type in the fifth column, with that type's law, and the afterglow is fitted to what is left.
# Name; what it is; times; luminance; whose law the flash has; its share; flash xy; afterglow xy; a note.
SULPHIDE_BLUE, SULPHIDE_YELLOW = (0.151, 0.032), (0.370, 0.540)
SHARE_BY_LUMINANCE = ("the flash is taken for a layer of {0} (the same material), its share for the ratio "
                      "of the two types' luminances;")
HALF = "the flash is given half the light and the law of {0}: both assumed;"
# P2 of .279 .534 (Tektronix), less half its light as afterglow of the colour of P22's zinc sulphide.
P2_FLASH, P2_AFTERGLOW = (0.2538, 0.4843), (0.310, 0.595)
TWO_LAYERS = [
    ("P2", "bluish green, then green", (370, 4700, 51e3), 60, "P31", 0.5, P2_FLASH, P2_AFTERGLOW, HALF +
     " colours: both together Tektronix's .279 .534, the afterglow that of P22's green, assumed. "
     "Another table of the same maker has 120 ms to 0.1 %."),
    ("P7", "blue flash, then yellowish green", (305, 5700, 66e3), 45, "P11", 25 / 45, SULPHIDE_BLUE,
     (0.357, 0.537), SHARE_BY_LUMINANCE + " colours: candidates not verified."),
    ("P7-long", "P7 after long excitation, as on a radar", (305, 5700, 1.5e6), 45, "P11", 25 / 45,
     SULPHIDE_BLUE, (0.357, 0.537), "0.1 % at 1500 ms by another table of the same maker; from there to "
     "a minute, as faint as it is said to glow in a dark room, a power of -1.1 (zinc sulphide's, Kuhn "
     "2002), assumed; " + SHARE_BY_LUMINANCE + " colours: candidates not verified."),
    ("P14", "purplish blue, then orange", (440, 6700, 55e3), 40, "P11", 25 / 40, SULPHIDE_BLUE,
     (0.504, 0.443), SHARE_BY_LUMINANCE + " flash of P7's colour; afterglow: the JEDEC register's as "
     "quoted from memory, not verified."),
    ("P17", "bluish green, then yellowish green", (130, 8700, 82.5e3), 30, "P15", 15 / 30, (0.246, 0.439),
     SULPHIDE_YELLOW, SHARE_BY_LUMINANCE + " colours of P15 and P28, not verified."),
    ("P32", "bluish green, then yellowish green", (1000, 18e3, 235e3), 25, "P11", 0.5, (0.245, 0.441),
     SULPHIDE_YELLOW, HALF + " colours of P24 and P28, assumed."),
]
ONE_MINUTE_US = 60e6

# No decay was found for these. Name; what it is; xy; time to 10 %, us; a note. Their law is P1's, stretched.
ASSUMED = [
    ("P39", "green of terminals, long", (0.223, 0.698), 150e3,
     "No measured decay found: P1's law (zinc silicate too) stretched to 150 ms to 10 %, as is quoted of "
     "terminals; the JEDEC class \"long\" is 0.1 to 1 s. Not verified. " + CANDIDATE),
    ("P134", "amber of terminals", (0.5448, 0.4544), 50e3,
     "No measured decay found: P1's law stretched to 50 ms to 10 %, as is quoted of amber monitors; the "
     "JEDEC class \"medium\" is 1 to 100 ms. Colour: the spectral locus at 585 nm. Not verified."),
]

# Colour tubes: name, what it is, xy of red, green and blue, whose primaries.
COLOUR_TUBES = [
    ("P22", "colour, SMPTE C", ((0.630, 0.340), (0.310, 0.595), (0.155, 0.070)), "SMPTE C"),
    ("P22-EBU", "colour, EBU", ((0.640, 0.330), (0.290, 0.600), (0.150, 0.060)), "EBU Tech. 3213"),
    ("P22-NTSC", "colour, NTSC 1953", ((0.67, 0.33), (0.21, 0.71), (0.14, 0.08)),
     "NTSC 1953; its silicate green and phosphate red decayed more slowly, which is not modelled"),
]

# Kuhn 2002: light after a pulse of 40 ns, relative units, t in microseconds; and the times to 10 %,
# 1 % and 0.1 % after 100 us of excitation, his law convolved exactly.
KUHN_FAST = [(90.0, 0.0318), (100.0, 0.227), (37.0, 1.06)]
KUHN_AMOUNT, KUHN_SHIFT_US = 210e-6, 5.5
KUHN_PULSE_US, KUHN_AFTER_PULSE_US = 0.04, 12.2
KUHN_AFTER_100_US = (205.0, 2030.0, 16.9e3)
# A power of -1.1 has no steady state. It is cut at the shortest longest time constant that still meets
# the times within this share.
KUHN_TOLERANCE = 0.03
