//! `textureGather`: a component of four texels.

use naga::{Function, Span, SwizzleComponent};

use crate::lower::{Item, Lowering, Refused, Reg};
use crate::machine::{Look, LookLod};

impl Lowering<'_> {
    /// The component that WGSL gathers.
    pub(in crate::lower) fn gathered(
        &self,
        texture: usize,
        component: SwizzleComponent,
        compared: bool,
        span: Span,
    ) -> Result<LookLod<Reg>, Refused> {
        let info = &self.layout.textures[texture];
        if info.dimension != "2d" || info.layered || compared {
            let message = "textureGather is there for textures of two dimensions only, not for cubes, layers and comparisons";
            return Err(Refused::new(message, span));
        }
        Ok(LookLod::Gather(component as usize))
    }

    /// What a call of GLSL's functions gives, which the front end lacks: they are declared by the intake's prelude. `None` of
    /// other functions.
    pub(in crate::lower) fn gather_call(
        &mut self,
        function: &Function,
        arguments: &[Item],
        span: Span,
    ) -> Result<Option<Vec<Reg>>, Refused> {
        let Some(name) = function.name.as_deref().filter(|name| is_stand_in(name)) else { return Ok(None) };
        let has_offset = name.ends_with("Offset");
        let [Item::Texture(texture), Item::Nothing, Item::Value(coordinates), rest @ ..] = arguments else {
            return Ok(None);
        };
        let mut rest = rest.iter().filter_map(|item| match item {
            Item::Value(regs) => Some(regs.clone()),
            _ => None,
        });
        let offset = if has_offset { rest.next() } else { None }.unwrap_or_default();
        let component = rest.next().unwrap_or_default();
        let look = Look {
            texture: *texture,
            coordinates: coordinates.clone(),
            layer: None,
            offset: self.constants(&offset, "the offset", span)?,
            compare: None,
            lod: LookLod::Gather(self.constants(&component, "the component", span)?[0].clamp(0, 3) as usize),
        };
        Ok(Some(self.look(look, 4, false)))
    }
}

/// Whether a function stands for one that the front end lacks; its body is of no meaning.
pub(crate) fn is_stand_in(name: &str) -> bool {
    matches!(name, "glanz_textureGather" | "glanz_textureGatherOffset")
}
