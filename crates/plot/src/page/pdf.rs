//! A page as PDF.

use std::collections::BTreeMap;

use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{CidFontType, FontFlags, LineJoinStyle, SystemInfo, UnicodeCmap};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, Str, TextStr};

use super::letters;
use super::shapes::{Anchor, Page, Raster, Shape, Text};
use super::style::Rgb8;

/// How hard streams are compressed, 0 to 10.
const EFFORT: u8 = 7;
/// The name of the font among the resources of the page.
const FONT: Name<'static> = Name(b"F0");
/// The name of the font itself, with the tag that subsets have.
const FONT_NAME: Name<'static> = Name(b"GLANZA+NotoSans-Regular");
/// The four corners of a circle as Bézier curves: how far control points are from the ends, in radii.
const CIRCLE: f32 = 0.552_284_8;

/// Glyphs of the page's texts, and their letters.
type Glyphs = BTreeMap<u16, char>;

/// The numbers of objects; images follow.
#[derive(Clone, Copy)]
struct Ids {
    catalog: Ref,
    pages: Ref,
    page: Ref,
    content: Ref,
    info: Ref,
    font: Ref,
    cid_font: Ref,
    descriptor: Ref,
    file: Ref,
    unicode: Ref,
}

impl Ids {
    fn new() -> Self {
        let [catalog, pages, page, content, info, font, cid_font, descriptor, file, unicode] =
            core::array::from_fn(|i| Ref::new(i as i32 + 1));
        Self { catalog, pages, page, content, info, font, cid_font, descriptor, file, unicode }
    }

    fn image(index: usize) -> Ref {
        Ref::new(11 + index as i32)
    }
}

/// The page as a document of one page, a point for a point. No dates are in it, so the same page is the same bytes.
pub(super) fn write(page: &Page, title: &str) -> Vec<u8> {
    let ids = Ids::new();
    let mut pdf = Pdf::new();
    pdf.catalog(ids.catalog).pages(ids.pages);
    pdf.pages(ids.pages).kids([ids.page]).count(1);
    pdf.document_info(ids.info).title(TextStr(title));
    let mut leaf = pdf.page(ids.page);
    leaf.media_box(Rect::new(0.0, 0.0, page.width as f32, page.height as f32));
    leaf.parent(ids.pages).contents(ids.content);
    let mut resources = leaf.resources();
    resources.fonts().pair(FONT, ids.font);
    let mut images = resources.x_objects();
    for index in 0..page.rasters.len() {
        images.pair(Name(image_name(index).as_bytes()), Ids::image(index));
    }
    images.finish();
    resources.finish();
    leaf.finish();
    let mut glyphs = Glyphs::new();
    let content = compress_to_vec_zlib(&content(page, &mut glyphs), EFFORT);
    pdf.stream(ids.content, &content).filter(Filter::FlateDecode);
    for (index, raster) in page.rasters.iter().enumerate() {
        image(&mut pdf, Ids::image(index), raster);
    }
    font(&mut pdf, ids, &glyphs);
    pdf.finish()
}

fn image_name(index: usize) -> String {
    format!("I{index}")
}

/// What is drawn: rasters, then shapes in their order, from the upper left corner as on the page.
fn content(page: &Page, glyphs: &mut Glyphs) -> Vec<u8> {
    let mut content = Content::new();
    content.transform([1.0, 0.0, 0.0, -1.0, 0.0, page.height as f32]);
    content.set_line_join(LineJoinStyle::RoundJoin);
    for (index, raster) in page.rasters.iter().enumerate() {
        let [x, y, width, height] =
            [raster.rect.x, raster.rect.y, raster.rect.width, raster.rect.height].map(|v| v as f32);
        content.save_state().transform([width, 0.0, 0.0, -height, x, y + height]);
        content.x_object(Name(image_name(index).as_bytes())).restore_state();
    }
    for shape in &page.shapes {
        match shape {
            Shape::Line { points, color, width } => {
                let [r, g, b] = parts(*color);
                content.set_stroke_rgb(r, g, b).set_line_width(*width as f32);
                path(&mut content, points);
                content.stroke();
            }
            Shape::Area { points, color } => {
                let [r, g, b] = parts(*color);
                content.set_fill_rgb(r, g, b);
                path(&mut content, points);
                content.close_path().fill_nonzero();
            }
            Shape::Disc { center, radius, color } => disc(&mut content, *center, *radius, *color),
            Shape::Text(text) => write_text(&mut content, text, glyphs),
        }
    }
    content.finish().into_vec()
}

fn path(content: &mut Content, points: &[(f64, f64)]) {
    for (index, (x, y)) in points.iter().enumerate() {
        match index {
            0 => content.move_to(*x as f32, *y as f32),
            _ => content.line_to(*x as f32, *y as f32),
        };
    }
    if points.is_empty() {
        content.move_to(0.0, 0.0);
    }
}

fn disc(content: &mut Content, (x, y): (f64, f64), radius: f64, color: Rgb8) {
    let [r, g, b] = parts(color);
    let (x, y, radius) = (x as f32, y as f32, radius as f32);
    content.set_fill_rgb(r, g, b).move_to(x + radius, y);
    let mut from = (1.0, 0.0);
    for to in [(0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (1.0, 0.0)] {
        let at = |(a, b): (f32, f32)| (x + radius * a, y + radius * b);
        let near =
            |one: (f32, f32), other: (f32, f32)| at((one.0 + CIRCLE * other.0, one.1 + CIRCLE * other.1));
        let ((x1, y1), (x2, y2), (x3, y3)) = (near(from, to), near(to, from), at(to));
        content.cubic_to(x1, y1, x2, y2, x3, y3);
        from = to;
    }
    content.fill_nonzero();
}

/// A line of text. The page is upside down here, so letters are turned back.
fn write_text(content: &mut Content, text: &Text, glyphs: &mut Glyphs) {
    let width = letters::width(&text.text, text.size);
    let before = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5 * width,
        Anchor::End => width,
    };
    let mut codes = Vec::with_capacity(2 * text.text.len());
    for letter in text.text.chars() {
        let glyph = letters::glyph(letter);
        glyphs.entry(glyph).or_insert(letter);
        codes.extend(glyph.to_be_bytes());
    }
    let (x, y) = text.at;
    let matrix = match text.upwards {
        true => [0.0, -1.0, -1.0, 0.0, x as f32, (y + before) as f32],
        false => [1.0, 0.0, 0.0, -1.0, (x - before) as f32, y as f32],
    };
    let [r, g, b] = parts(text.color);
    content.set_fill_rgb(r, g, b).begin_text().set_font(FONT, text.size as f32).set_text_matrix(matrix);
    content.show(Str(&codes)).end_text();
}

fn parts(color: Rgb8) -> [f32; 3] {
    color.map(|code| f32::from(code) / 255.0)
}

fn image(pdf: &mut Pdf, id: Ref, raster: &Raster) {
    let bytes = compress_to_vec_zlib(&raster.rgb, EFFORT);
    let mut image = pdf.image_xobject(id, &bytes);
    image.filter(Filter::FlateDecode);
    image.width(raster.columns as i32).height(raster.rows as i32);
    image.bits_per_component(8).interpolate(false).color_space().device_rgb();
}

/// The font, embedded whole: a subset already. Its letters are numbered by glyph.
fn font(pdf: &mut Pdf, ids: Ids, glyphs: &Glyphs) {
    let system = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };
    let mut font = pdf.type0_font(ids.font);
    font.base_font(FONT_NAME).encoding_predefined(Name(b"Identity-H"));
    font.descendant_font(ids.cid_font).to_unicode(ids.unicode);
    font.finish();
    let mut cid = pdf.cid_font(ids.cid_font);
    cid.subtype(CidFontType::Type2).base_font(FONT_NAME).system_info(system);
    cid.font_descriptor(ids.descriptor).default_width(0.0).cid_to_gid_map_predefined(Name(b"Identity"));
    let mut widths = cid.widths();
    for (glyph, letter) in glyphs {
        widths.consecutive(*glyph, [letters::width(&letter.to_string(), 1000.0) as f32]);
    }
    widths.finish();
    cid.finish();
    let metrics = letters::metrics();
    let mut descriptor = pdf.font_descriptor(ids.descriptor);
    descriptor.name(FONT_NAME).flags(FontFlags::NON_SYMBOLIC).bbox(Rect::new(-600.0, -400.0, 2000.0, 1200.0));
    descriptor.italic_angle(0.0).ascent(metrics.0).descent(metrics.1).cap_height(714.0).stem_v(80.0);
    descriptor.font_file2(ids.file);
    descriptor.finish();
    let bytes = compress_to_vec_zlib(letters::FILE, EFFORT);
    let mut file = pdf.stream(ids.file, &bytes);
    file.filter(Filter::FlateDecode).pair(Name(b"Length1"), letters::FILE.len() as i32);
    file.finish();
    let mut unicode = UnicodeCmap::new(Name(b"GlanzUnicode"), system);
    for (glyph, letter) in glyphs {
        unicode.pair(*glyph, *letter);
    }
    let unicode = compress_to_vec_zlib(&unicode.finish().into_vec(), EFFORT);
    pdf.stream(ids.unicode, &unicode).filter(Filter::FlateDecode);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_glyphs_of_the_font_with_their_letters() {
        let mut page = Page::new(100, 50);
        page.text("θh à", (10.0, 20.0), Anchor::Middle, 10.0, [0; 3]);
        let mut glyphs = Glyphs::new();
        let drawn = String::from_utf8_lossy(&content(&page, &mut glyphs)).into_owned();
        let letters: String = glyphs.values().collect();
        assert!(['θ', 'h', ' ', 'à'].iter().all(|letter| letters.contains(*letter)), "{letters}");
        assert!(glyphs.keys().all(|glyph| *glyph != 0) && drawn.contains("/F0 10 Tf"), "{drawn}");
    }

    #[test]
    fn the_same_page_is_the_same_bytes_and_a_whole_file() {
        let mut page = Page::new(100, 50);
        page.disc((50.0, 25.0), 10.0, [255, 0, 0]);
        page.line([(0.0, 0.0), (100.0, 50.0)], [0; 3], 2.0);
        let bytes = write(&page, "été");
        assert!(bytes.starts_with(b"%PDF-1.7") && bytes.ends_with(b"%%EOF"));
        assert_eq!(bytes, write(&page, "été"));
    }
}
