//! The loops, in each language. All make [`ITERATIONS`] iterations.

/// Iterations of each loop.
pub(crate) const ITERATIONS: u64 = 300_000;

/// One loop. `{N}` stands for the number of iterations.
pub(crate) struct Program {
    pub(crate) name: &'static str,
    /// Stored text of a program; leaves its result in `P0`.
    acrobasic: &'static str,
    /// Body of a function that returns its result.
    lua: &'static str,
    /// Body of a function that returns its result.
    python: &'static str,
}

impl Program {
    /// The whole project in AcroBASIC.
    pub(crate) fn acrobasic(&self) -> String {
        format!("SYS\nDIM P(4)\nPROG0\nPROGRAM\n{}\nENDP\n", filled(self.acrobasic))
    }

    pub(crate) fn lua(&self) -> String {
        filled(self.lua)
    }

    pub(crate) fn python(&self) -> String {
        filled(self.python)
    }
}

fn filled(text: &str) -> String {
    text.replace("{N}", &ITERATIONS.to_string())
}

/// The loops that are compared.
pub(crate) const PROGRAMS: &[Program] = &[
    Program {
        name: "sum of thirds",
        acrobasic: "DIM LV(1)\nDIM DV(1)\nWHILE (LV0 < {N})\nLV0 = LV0 + 1\n\
                    IF (LV0 MOD 3 = 0) THEN DV0 = DV0 + LV0 * 0.5\nWEND\nP0 = DV0",
        lua: "local i, s = 0, 0.0\nwhile i < {N} do\n i = i + 1\n if i % 3 == 0 then s = s + i * 0.5 end\nend\nreturn s",
        python: "    i = 0\n    s = 0.0\n    while i < {N}:\n        i = i + 1\n        if i % 3 == 0:\n            \
                 s = s + i * 0.5\n    return s",
    },
    Program {
        name: "integer WHILE",
        acrobasic: "DIM LV(2)\nWHILE (LV0 < {N})\nLV1 = LV1 + LV0 MOD 7\nLV0 = LV0 + 1\nWEND\nP0 = LV1",
        lua: "local i, s = 0, 0\nwhile i < {N} do\n s = s + i % 7\n i = i + 1\nend\nreturn s",
        python: "    i = 0\n    s = 0\n    while i < {N}:\n        s = s + i % 7\n        i = i + 1\n    return s",
    },
    Program {
        name: "FOR over array",
        acrobasic: "DIM LV(2)\nDIM LA(1)\nDIM LA0(100)\nFOR LV1 = 1 TO {N} / 100\nFOR LV0 = 0 TO 99\n\
                    LA0(LV0) = LA0(LV0) + LV0\nNEXT\nNEXT\nP0 = LA0(99)",
        lua: "local a = {}\nfor i = 0, 99 do a[i] = 0 end\nfor j = 1, {N} // 100 do\n for i = 0, 99 do\n  \
              a[i] = a[i] + i\n end\nend\nreturn a[99]",
        python: "    a = [0] * 100\n    for j in range({N} // 100):\n        for i in range(100):\n            \
                 a[i] = a[i] + i\n    return a[99]",
    },
    Program {
        name: "GOSUB",
        acrobasic: "DIM LV(1)\nWHILE (LV0 < {N})\nGOSUB Count\nWEND\nP0 = LV0\nEND\n_Count\nLV0 = LV0 + 1\nRETURN",
        lua: "local i = 0\nlocal function count() i = i + 1 end\nwhile i < {N} do count() end\nreturn i",
        python: "    i = 0\n    def count():\n        nonlocal i\n        i = i + 1\n    while i < {N}:\n        \
                 count()\n    return i",
    },
    Program {
        name: "P parameters",
        acrobasic: "P1 = 0\nWHILE (P1 < {N})\nP1 = P1 + 1\nP0 = P0 + P1 * 0.5\nWEND",
        lua: "p0, p1 = 0.0, 0.0\nwhile p1 < {N} do\n p1 = p1 + 1\n p0 = p0 + p1 * 0.5\nend\nreturn p0",
        python: "    global p0, p1\n    p0 = p1 = 0.0\n    while p1 < {N}:\n        p1 = p1 + 1\n        \
                 p0 = p0 + p1 * 0.5\n    return p0",
    },
];
