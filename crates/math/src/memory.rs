//! How much memory work may take.

use core::fmt;
use core::str::FromStr;

/// Decimal and binary units, by the names that sizes are read with.
const UNITS: [(&str, u64); 9] = [
    ("B", 1),
    ("kB", 1000),
    ("MB", 1_000_000),
    ("GB", 1_000_000_000),
    ("TB", 1_000_000_000_000),
    ("KiB", 1 << 10),
    ("MiB", 1 << 20),
    ("GiB", 1 << 30),
    ("TiB", 1 << 40),
];

/// A budget of memory, asked before memory is taken in proportion to what a file or a setting says. It counts what work is known to hold
/// at its peak, not what the system reports.
///
/// ```
/// use glanz_math::MemoryBudget;
///
/// let mut budget: MemoryBudget = "2 GB".parse()?;
/// budget.take("the first texture", 1_500_000_000)?;
/// let error = budget.take("the second texture", 1_500_000_000).unwrap_err();
/// assert_eq!(error.needed(), 3_000_000_000);
/// assert!(error.to_string().ends_with("it takes at least --memory 3GB"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemoryBudget {
    total: u64,
    taken: u64,
}

impl Default for MemoryBudget {
    /// 8 GB: half of what most computers that draw have, so that the rest of the machine goes on. Where pointers have 32 bits, half of
    /// what they reach.
    fn default() -> Self {
        let reach = u64::try_from(usize::MAX / 2).unwrap_or(u64::MAX);
        Self::of_bytes(reach.min(8_000_000_000))
    }
}

impl MemoryBudget {
    /// A budget of so many bytes, of which nothing is taken.
    pub const fn of_bytes(total: u64) -> Self {
        Self { total, taken: 0 }
    }

    /// All bytes of it.
    pub const fn total(self) -> u64 {
        self.total
    }

    /// The bytes that are taken already.
    pub const fn taken(self) -> u64 {
        self.taken
    }

    /// The bytes that may still be taken.
    pub const fn left(self) -> u64 {
        self.total.saturating_sub(self.taken)
    }

    /// The same budget, of which nothing is taken.
    #[must_use]
    pub const fn whole(self) -> Self {
        Self::of_bytes(self.total)
    }

    /// Takes so many bytes for something.
    ///
    /// # Errors
    /// If they are more than there are; nothing is taken then.
    pub fn take(&mut self, what: impl fmt::Display, bytes: u64) -> Result<(), OverBudget> {
        self.check(what, bytes)?;
        self.taken = self.taken.saturating_add(bytes);
        Ok(())
    }

    /// That so many bytes could be taken for something, which is gone again soon.
    ///
    /// # Errors
    /// If they are more than there are.
    pub fn check(self, what: impl fmt::Display, bytes: u64) -> Result<(), OverBudget> {
        match bytes <= self.left() {
            true => Ok(()),
            false => Err(OverBudget { what: what.to_string(), bytes, budget: self }),
        }
    }
}

impl fmt::Display for MemoryBudget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&shown(self.total))
    }
}

/// Something wants more memory than a budget has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OverBudget {
    what: String,
    bytes: u64,
    budget: MemoryBudget,
}

impl OverBudget {
    /// The least budget that would do.
    pub fn needed(&self) -> u64 {
        self.budget.taken.saturating_add(self.bytes)
    }
}

impl fmt::Display for OverBudget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, bytes, budget } = self;
        let (needed, bytes) = (shown(self.needed()), shown(*bytes));
        write!(f, "expected at most {budget} of memory, found ")?;
        match budget.taken {
            0 => write!(f, "{bytes} for {what}")?,
            taken => {
                write!(f, "{needed}: {bytes} for {what} beside {} of what came before", shown(taken))?;
            }
        }
        write!(f, "; it takes at least --memory {}", option(self.needed()))
    }
}

impl core::error::Error for OverBudget {}

/// A size that is none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MemorySizeError {
    found: String,
}

impl fmt::Display for MemorySizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found: String = self.found.chars().take(40).collect();
        write!(f, "expected a size above 0 in B, kB, MB, GB or GiB, such as 8GB, found '{found}'")
    }
}

impl core::error::Error for MemorySizeError {}

impl FromStr for MemoryBudget {
    type Err = MemorySizeError;

    fn from_str(text: &str) -> Result<Self, MemorySizeError> {
        let wrong = || MemorySizeError { found: text.to_owned() };
        let trimmed = text.trim();
        let end = trimmed.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(trimmed.len());
        let (number, unit) = trimmed.split_at(end);
        let known = UNITS.iter().find(|(name, _)| name.eq_ignore_ascii_case(unit.trim_start()));
        let (number, (_, unit)) = (number.parse::<f64>().map_err(|_| wrong())?, known.ok_or_else(wrong)?);
        let bytes = number * *unit as f64;
        match (1.0..=i64::MAX as f64).contains(&bytes) {
            true => Ok(Self::of_bytes(bytes as u64)),
            false => Err(wrong()),
        }
    }
}

/// A size for people: three digits, rounded up, so that what is too much also reads as too much.
fn shown(bytes: u64) -> String {
    let (unit, size) = unit_of(bytes);
    let value = bytes as f64 / size as f64;
    let steps = if value < 10.0 {
        100.0
    } else if value < 100.0 {
        10.0
    } else {
        1.0
    };
    // A number that has no more digits stays what it is in spite of rounding.
    format!("{} {unit}", (value * steps - 1e-9).ceil() / steps)
}

/// A size as the option takes it, rounded up to whole units.
fn option(bytes: u64) -> String {
    let (unit, size) = unit_of(bytes);
    format!("{}{unit}", bytes.div_ceil(size))
}

/// The decimal unit of a size.
fn unit_of(bytes: u64) -> (&'static str, u64) {
    UNITS[..5].iter().rfind(|(_, size)| *size <= bytes).copied().unwrap_or(("B", 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_in_decimal_and_binary_units() {
        let cases = [
            ("8GB", 8_000_000_000),
            ("1.5 gb", 1_500_000_000),
            ("2GiB", 2 << 30),
            ("64MB", 64_000_000),
            ("3kB", 3000),
            ("100B", 100),
        ];
        for (text, bytes) in cases {
            assert_eq!(text.parse::<MemoryBudget>().map(MemoryBudget::total), Ok(bytes), "{text}");
        }
        for text in ["", "8", "GB", "-1GB", "0GB", "1e3GB", "inf GB", "8GB free", "1..2GB", "99999999999TB"] {
            assert!(text.parse::<MemoryBudget>().is_err(), "{text}");
        }
    }

    #[test]
    fn an_error_tells_who_wants_how_much_and_how_to_allow_it() {
        let mut budget = MemoryBudget::of_bytes(8_000_000_000);
        assert_eq!(budget.take("a", 8_000_000_000), Ok(()));
        assert_eq!(
            budget.take("the texture 'b.png'", 1).unwrap_err().to_string(),
            "expected at most 8 GB of memory, found 8.01 GB: 1 B for the texture 'b.png' beside 8 GB of what came before; \
             it takes at least --memory 9GB"
        );
        assert_eq!(
            MemoryBudget::of_bytes(1 << 20).check("a picture", 2_512_000).unwrap_err().to_string(),
            "expected at most 1.05 MB of memory, found 2.52 MB for a picture; it takes at least --memory 3MB"
        );
        assert_eq!((budget.left(), budget.whole().left()), (0, 8_000_000_000));
    }
}
