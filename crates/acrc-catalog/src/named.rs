//! The macro behind every closed vocabulary of the catalogue.
//!
//! A variant, its spelling and its id stand in one line, so that they cannot drift apart. The build script uses the same declarations to check the
//! data files.

/// Declares an enumeration whose variants have a spelling and a small stable id (their position: append only).
macro_rules! named_enum {
    (
        $(#[$meta:meta])*
        pub enum $name:ident { $($(#[$variant_meta:meta])* $variant:ident = $text:literal,)+ }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u8)]
        pub enum $name { $($(#[$variant_meta])* $variant,)+ }

        impl $name {
            /// Every variant, in the order of the ids.
            pub const ALL: &'static [Self] = &[$(Self::$variant,)+];

            /// The spelling in programs, data files and reports.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $text,)+ }
            }

            /// The variant with this spelling, in any case.
            pub fn from_name(name: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|variant| variant.name().eq_ignore_ascii_case(name))
            }

            /// The id; stored images rely on it.
            pub const fn id(self) -> u8 {
                self as u8
            }

            /// The variant with this id.
            pub fn from_id(id: u8) -> Option<Self> {
                Self::ALL.get(usize::from(id)).copied()
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.pad(self.name())
            }
        }
    };
}
