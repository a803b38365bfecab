//! The steps one by one, for fuzz targets.

use super::preprocess::{Preprocessor, Version};
use super::rewrite::rewrite;
use super::token::tokens;
use super::{Complaint, Include, Map, Origin, Sources};
use crate::Stage;

/// Where the tokens stem from that the preprocessor gives.
pub(crate) fn expand(
    sources: &mut Sources,
    file: u32,
    include: Option<Include<'_>>,
) -> Result<Vec<Origin>, Complaint> {
    let length = sources.text(file).len();
    let (tokens, _) = Preprocessor::new(sources, include).run(file, 0, length)?;
    Ok(tokens.into_iter().map(|token| token.origin).collect())
}

/// What the rewriter makes of a text without directives.
pub(crate) fn rewrite_text(text: &str, file: u32, stage: Stage) -> Result<(String, Map), Complaint> {
    let rewritten = rewrite(&tokens(text, file, 0), stage, Version { number: 330, es: false }, false)?;
    Ok((rewritten.text, rewritten.map))
}
