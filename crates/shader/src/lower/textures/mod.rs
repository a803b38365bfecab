//! Looks into textures.

pub(super) mod gather;

use naga::{Expression, Handle, ImageQuery, SampleLevel, Span};

use super::{Frame, Item, Lowering, Refused, Reg, VirtualOp};
use crate::machine::{Code, Look, LookLod};

impl<'a> Lowering<'a> {
    pub(super) fn texture(
        &mut self,
        frame: &mut Frame<'a>,
        e: Handle<Expression>,
        span: Span,
    ) -> Result<Item, Refused> {
        match &frame.function.expressions[e] {
            Expression::ImageSample {
                image,
                gather,
                coordinate,
                array_index,
                offset,
                level,
                depth_ref,
                ..
            } => {
                let coordinates = self.value(frame, *coordinate)?;
                let texture = self.image(frame, *image)?;
                let lod = match gather {
                    Some(component) => self.gathered(texture, *component, depth_ref.is_some(), span)?,
                    None => self.level(frame, level)?,
                };
                let look = Look {
                    texture,
                    coordinates,
                    layer: self.optional(frame, *array_index)?,
                    offset: self.offset(*offset, frame, span)?,
                    compare: self.optional(frame, *depth_ref)?,
                    lod,
                };
                let n = if depth_ref.is_some() { 1 } else { self.texel_size(frame, e) };
                Ok(Item::Value(self.look(look, n, false)))
            }
            Expression::ImageLoad { image, coordinate, array_index, level, .. } => {
                let look = Look {
                    texture: self.image(frame, *image)?,
                    coordinates: self.value(frame, *coordinate)?,
                    layer: self.optional(frame, *array_index)?,
                    offset: [0; 3],
                    compare: None,
                    lod: LookLod::Texel(self.optional(frame, *level)?),
                };
                let n = self.texel_size(frame, e);
                Ok(Item::Value(self.look(look, n, false)))
            }
            Expression::ImageQuery { image, query } => {
                let texture = self.image(frame, *image)?;
                let is_layers = matches!(query, ImageQuery::NumLayers);
                let lod = match query {
                    ImageQuery::Size { level } => LookLod::Size(self.optional(frame, *level)?),
                    ImageQuery::NumLevels => LookLod::Levels,
                    ImageQuery::NumLayers => LookLod::Size(None),
                    ImageQuery::NumSamples => {
                        return Err(Refused::new("textures of several samples are not there", span));
                    }
                };
                let look =
                    Look { texture, coordinates: vec![], layer: None, offset: [0; 3], compare: None, lod };
                let n = if is_layers { 3 } else { self.texel_size(frame, e) };
                let answer = self.look(look, n, true);
                Ok(Item::Value(if is_layers { answer[2..].to_vec() } else { answer }))
            }
            _ => Err(Refused::new("this is no look into a texture", span)),
        }
    }

    /// Components of the answer.
    fn texel_size(&self, frame: &Frame<'_>, e: Handle<Expression>) -> usize {
        self.size(&self.inner(frame, e)).clamp(1, 4)
    }

    fn image(&mut self, frame: &mut Frame<'a>, e: Handle<Expression>) -> Result<usize, Refused> {
        match self.item(frame, e)? {
            Item::Texture(slot) => Ok(slot),
            _ => {
                Err(Refused::new("arrays of textures are not there", frame.function.expressions.get_span(e)))
            }
        }
    }

    fn optional(
        &mut self,
        frame: &mut Frame<'a>,
        e: Option<Handle<Expression>>,
    ) -> Result<Option<Reg>, Refused> {
        e.map(|e| Ok(self.value(frame, e)?[0])).transpose()
    }

    fn level(&mut self, frame: &mut Frame<'a>, level: &SampleLevel) -> Result<LookLod<Reg>, Refused> {
        Ok(match level {
            SampleLevel::Auto => LookLod::Auto,
            SampleLevel::Zero => LookLod::Level(self.word(0)),
            SampleLevel::Exact(level) => LookLod::Level(self.value(frame, *level)?[0]),
            SampleLevel::Bias(bias) => LookLod::Bias(self.value(frame, *bias)?[0]),
            SampleLevel::Gradient { x, y } => {
                LookLod::Gradient(self.value(frame, *x)?, self.value(frame, *y)?)
            }
        })
    }

    /// Offsets are constants.
    fn offset(
        &mut self,
        offset: Option<Handle<Expression>>,
        frame: &mut Frame<'a>,
        span: Span,
    ) -> Result<[i32; 3], Refused> {
        let Some(e) = offset else { return Ok([0; 3]) };
        let regs = self.value(frame, e)?;
        self.constants(&regs, "the offset", span)
    }

    /// Up to three whole numbers that must be constants.
    pub(super) fn constants(&self, regs: &[Reg], what: &str, span: Span) -> Result<[i32; 3], Refused> {
        let mut out = [0; 3];
        for (out, r) in out.iter_mut().zip(regs) {
            let known = self.state.prologue.iter().find(|op| op.d == *r && op.code == Code::Imm);
            let known = known.ok_or_else(|| Refused::new(format!("{what} must be a constant"), span))?;
            *out = known.imm as i32;
        }
        Ok(out)
    }

    /// Sizes are the same for the whole draw if their level is, but other looks are done where they stand.
    pub(super) fn look(&mut self, look: Look<Reg>, n: usize, is_query: bool) -> Vec<Reg> {
        let reads = look.reads();
        let hoist = is_query && self.is_hoisted(&reads);
        let even = self.is_even(&reads) && !matches!(look.lod, LookLod::Auto | LookLod::Bias(_));
        let d = self.fresh(n);
        let imm = self.state.looks.len() as u32;
        self.state.looks.push(look);
        self.push(hoist, VirtualOp { n: n as u16, d: d[0], ..VirtualOp::plain(Code::Texture, imm) });
        d.iter().for_each(|r| self.state.even[*r as usize] = even);
        d
    }
}
