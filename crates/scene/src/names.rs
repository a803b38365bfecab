//! Enums whose variants have names in files, on the command line and in user interfaces.

/// A name out of a few. From one list come the enum, `ALL`, `name`, `FromStr`, `Display`, serde and the JSON Schema.
macro_rules! names {
    ($(#[$doc:meta])* $vis:vis $name:ident {
        $($(#[doc = $help:literal])+ $variant:ident = $text:literal),+ $(,)?
    } default $default:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        $vis enum $name {
            $($(#[doc = $help])+ #[serde(rename = $text)] $variant),+
        }

        #[allow(dead_code, unreachable_pub, reason = "some lists are private, and not printed")]
        impl $name {
            /// All of them, with their names and what they mean.
            pub const ALL: &[(Self, &'static str, &'static str)] =
                &[$((Self::$variant, $text, concat!($($help),+).trim_ascii())),+];

            /// The name in files and on the command line.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $text),+
                }
            }
        }

        impl Default for $name {
            fn default() -> Self {
                Self::$default
            }
        }

        impl core::fmt::Display for $name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str(self.name())
            }
        }

        impl core::str::FromStr for $name {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                let found = Self::ALL.iter().find(|(_, name, _)| *name == text).map(|(value, ..)| *value);
                found.ok_or_else(|| {
                    let known = [$($text),+].join(", ");
                    format!("expected one of {known}, found '{text}'")
                })
            }
        }
    };
}
pub(crate) use names;
