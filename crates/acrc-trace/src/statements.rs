//! Which statement each program stood at over time, in bounded memory.
//!
//! A program has an entry whenever it stands somewhere else than before, so a statement that takes long costs as much as one that does not. When there
//! is no room for more, entries of one program that follow each other within a time, the resolution, become one: the last of them, since that is where the
//! program stood afterwards. The resolution doubles until half of the room is free. From then on the log is right to within the resolution.

/// The first resolution, in seconds: two slices of a program.
const FIRST_RESOLUTION: f64 = 0.002;

/// A place in the text of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// Index of the file; `None` for the text that the controller holds.
    pub file: Option<u32>,
    /// Line, from 1.
    pub line: u32,
    /// Statement of the line, from 1.
    pub statement: u32,
}

/// A program began to stand somewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Since when, in seconds.
    pub time: f64,
    /// Where.
    pub place: Place,
    /// The word for what it does there: `running`, `waiting`, `ended`.
    pub state: &'static str,
}

/// What one program did.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramLog {
    /// Its name.
    pub name: String,
    /// In order of time.
    pub entries: Vec<Entry>,
}

/// What all programs did.
#[derive(Clone, Debug)]
pub struct StatementLog {
    programs: Vec<ProgramLog>,
    /// Entries of all programs.
    count: usize,
    limit: usize,
    resolution: f64,
}

impl StatementLog {
    /// Keeps at most so many entries of all programs together.
    #[must_use]
    pub fn new(limit: usize) -> Self {
        Self { programs: Vec::new(), count: 0, limit, resolution: 0.0 }
    }

    /// Takes note of where a program stands at a time in seconds. `name` is asked for when its `number` is new; numbers are given by the caller.
    pub fn record(&mut self, number: usize, name: impl FnOnce() -> String, entry: Entry) {
        if number >= self.programs.len() {
            self.programs.resize_with(number + 1, || ProgramLog { name: String::new(), entries: Vec::new() });
        }
        let Some(program) = self.programs.get_mut(number) else { return };
        if program.name.is_empty() {
            program.name = name();
        }
        let before = program.entries.len();
        add(&mut program.entries, entry, self.resolution);
        self.count = self.count + program.entries.len() - before;
        if self.count > self.limit {
            self.thin_out();
        }
    }

    fn thin_out(&mut self) {
        // Each program keeps at least one entry, so there is an end to it.
        while self.count > self.limit / 2 && self.programs.iter().any(|program| program.entries.len() > 2) {
            self.resolution = if self.resolution == 0.0 { FIRST_RESOLUTION } else { 2.0 * self.resolution };
            for program in &mut self.programs {
                for entry in std::mem::take(&mut program.entries) {
                    add(&mut program.entries, entry, self.resolution);
                }
            }
            self.count = self.programs.iter().map(|program| program.entries.len()).sum();
        }
    }

    /// The programs that were seen.
    pub fn programs(&self) -> impl Iterator<Item = &ProgramLog> {
        self.programs.iter().filter(|program| !program.entries.is_empty())
    }

    /// To within how many seconds the log is right; 0 when nothing was left out.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }
}

/// Adds an entry behind the others. One within the same stretch of `resolution` seconds takes the place of the one before.
fn add(entries: &mut Vec<Entry>, entry: Entry, resolution: f64) {
    let window = |time: f64| (time / resolution).floor();
    if let Some(last) = entries.last()
        && resolution > 0.0
        && entries.len() > 1
        && window(last.time) == window(entry.time)
    {
        entries.pop();
    }
    let stays = entries.last().is_some_and(|last| last.place == entry.place && last.state == entry.state);
    if !stays {
        entries.push(entry);
    }
}
