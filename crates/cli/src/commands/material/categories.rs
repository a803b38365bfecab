//! Categories on the command line.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use glanz_scene::library::Category;

/// Parses the name of a category.
pub(super) fn categories() -> impl TypedValueParser<Value = Category> {
    PossibleValuesParser::new(Category::ALL.map(Category::name))
        .map(|name| Category::named(&name).expect("the parser lets only known names through"))
}
