//! The reader of OBJ files and of the MTL files that they name: what follows the first zero byte is
//! the MTL file, and what follows the second its picture.

#![no_main]

mod check;

use std::collections::HashMap;

use glanz_scene::read::Format;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let mut parts = bytes.splitn(3, |byte| *byte == 0);
    let obj = parts.next().unwrap_or_default();
    let names = ["m.mtl", "wood.png"].map(str::to_owned);
    let files: HashMap<String, Vec<u8>> = names.into_iter().zip(parts.map(<[u8]>::to_vec)).collect();
    check::read_with(obj, Format::Obj, &files);
});
