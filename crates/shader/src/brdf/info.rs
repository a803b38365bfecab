//! Descriptions of models that are known at run time only.
//!
//! A `ModelInfo` lives as long as the program, since everything that names models takes it so. Equal ones are kept once:
//! a file that is read again adds nothing, one that has been changed a few hundred bytes.

use std::sync::{Mutex, PoisonError};

use glanz_bsdf::{ModelInfo, ParamInfo};

static TEXTS: Mutex<Vec<&'static str>> = Mutex::new(Vec::new());
static PARAMS: Mutex<Vec<&'static [ParamInfo]>> = Mutex::new(Vec::new());
static INFOS: Mutex<Vec<&'static ModelInfo>> = Mutex::new(Vec::new());

fn kept<T: ?Sized + PartialEq>(list: &Mutex<Vec<&'static T>>, value: Box<T>) -> &'static T {
    let mut list = list.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = list.iter().find(|known| **known == &*value) {
        return known;
    }
    let value: &'static T = Box::leak(value);
    list.push(value);
    value
}

/// A text that lives on.
pub(super) fn text(text: &str) -> &'static str {
    kept(&TEXTS, text.into())
}

/// A list of parameters that lives on.
pub(super) fn params(params: Vec<ParamInfo>) -> &'static [ParamInfo] {
    kept(&PARAMS, params.into())
}

/// A description that lives on.
pub(super) fn info(info: ModelInfo) -> &'static ModelInfo {
    kept(&INFOS, Box::new(info))
}
