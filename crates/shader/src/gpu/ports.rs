//! Inputs and outputs: what has which type and which location.

use naga::{
    BinaryOperator, Binding, BuiltIn, Expression, FunctionArgument, Handle, Interpolation, Sampling, Scalar,
    ScalarKind, StructMember, Type, TypeInner, VectorSize,
};

use super::build::Build;
use super::refused;
use crate::ShaderError;

type Value = Handle<Expression>;

/// A scalar, vector or matrix as columns.
#[derive(Clone, Copy)]
pub(super) struct Columns {
    pub(super) count: usize,
    pub(super) rows: usize,
    pub(super) scalar: Scalar,
}

impl Columns {
    /// Those of a type.
    pub(super) fn of(build: &Build, ty: Handle<Type>) -> Result<Self, ShaderError> {
        let found = match build.module.types[ty].inner {
            TypeInner::Scalar(scalar) => Self { count: 1, rows: 1, scalar },
            TypeInner::Vector { size, scalar } => Self { count: 1, rows: size as usize, scalar },
            TypeInner::Matrix { columns, rows, scalar } => {
                Self { count: columns as usize, rows: rows as usize, scalar }
            }
            _ => return Err(refused("a value of this type does not go from the host or between stages")),
        };
        match (found.scalar.kind, found.scalar.width) {
            (ScalarKind::Bool, _) | (_, 4) => Ok(found),
            _ => Err(refused("numbers of other than 32 bits are not there")),
        }
    }

    pub(super) fn scalars(self) -> usize {
        self.count * self.rows
    }

    /// The type of one column of another scalar.
    fn column(self, build: &mut Build, scalar: Scalar) -> Handle<Type> {
        build.ty(match size(self.rows) {
            Some(size) => TypeInner::Vector { size, scalar },
            None => TypeInner::Scalar(scalar),
        })
    }

    /// What stages give each other in its place: truth values are numbers.
    pub(super) fn carried(self) -> Scalar {
        if self.scalar.kind == ScalarKind::Bool { Scalar::U32 } else { self.scalar }
    }

    /// A value of its columns, or of its only one.
    fn join(self, build: &mut Build, ty: Handle<Type>, columns: Vec<Value>) -> Value {
        match columns[..] {
            [only] => only,
            _ => build.compose(ty, columns),
        }
    }
}

/// The size of a vector of so many components; none of a scalar.
pub(super) fn size(rows: usize) -> Option<VectorSize> {
    Some(match rows {
        2 => VectorSize::Bi,
        3 => VectorSize::Tri,
        4 => VectorSize::Quad,
        _ => return None,
    })
}

/// A location with how what is there goes between vertices.
pub(super) fn location(location: u32, scalar: Scalar, how: crate::Interpolation) -> Binding {
    let is_float = scalar.kind == ScalarKind::Float;
    let (interpolation, sampling) = match how {
        crate::Interpolation::Perspective if is_float => (Interpolation::Perspective, Sampling::Center),
        crate::Interpolation::Linear if is_float => (Interpolation::Linear, Sampling::Center),
        _ => (Interpolation::Flat, Sampling::Either),
    };
    Binding::Location {
        location,
        interpolation: Some(interpolation),
        sampling: Some(sampling),
        blend_src: None,
        per_primitive: false,
    }
}

impl Build {
    /// The words from `first` on as a value of a type without structs and arrays.
    pub(super) fn of_words(
        &mut self,
        block: Value,
        first: usize,
        ty: Handle<Type>,
    ) -> Result<Value, ShaderError> {
        let columns = Columns::of(self, ty)?;
        let mut whole = Vec::with_capacity(columns.count);
        for column in 0..columns.count {
            let word = |row: usize| first + column * columns.rows + row;
            let parts: Vec<Value> =
                (0..columns.rows).map(|row| self.word(block, word(row), columns.scalar)).collect();
            let ty = columns.column(self, columns.scalar);
            whole.push(columns.join(self, ty, parts));
        }
        Ok(columns.join(self, ty, whole))
    }

    /// Arguments at locations from `first` on, as a value of a type without structs and arrays.
    pub(super) fn of_locations(
        &mut self,
        first: u32,
        ty: Handle<Type>,
        how: crate::Interpolation,
    ) -> Result<Value, ShaderError> {
        let columns = Columns::of(self, ty)?;
        let carried = columns.carried();
        let mut whole = Vec::with_capacity(columns.count);
        for column in 0..columns.count {
            let at = first + column as u32;
            let column = columns.column(self, carried);
            let binding = Some(location(at, carried, how));
            let argument = FunctionArgument { name: Some(format!("location{at}")), ty: column, binding };
            let value = self.argument(argument);
            whole.push(self.truth(value, columns)?);
        }
        Ok(columns.join(self, ty, whole))
    }

    /// What is carried as what it means.
    fn truth(&mut self, value: Value, columns: Columns) -> Result<Value, ShaderError> {
        match (columns.scalar.kind, columns.rows) {
            (ScalarKind::Bool, 1) => Ok(self.meant_by(value, ScalarKind::Bool)),
            (ScalarKind::Bool, _) => {
                let ty = columns.column(self, Scalar::U32);
                let zero = self.zero(ty);
                Ok(self.binary(BinaryOperator::NotEqual, value, zero))
            }
            _ => Ok(value),
        }
    }

    /// The columns of a value, as stages carry them, with their types.
    pub(super) fn carried(
        &mut self,
        value: Value,
        ty: Handle<Type>,
    ) -> Result<Vec<(Value, Handle<Type>, Scalar)>, ShaderError> {
        let columns = Columns::of(self, ty)?;
        let carried = columns.carried();
        let column_type = columns.column(self, carried);
        let mut all = Vec::with_capacity(columns.count);
        for column in 0..columns.count {
            let own = if columns.count > 1 { self.member(value, column) } else { value };
            let own = match columns.scalar.kind {
                ScalarKind::Bool => {
                    let (kind, convert) = (ScalarKind::Uint, Some(4));
                    self.value(Expression::As { expr: own, kind, convert })
                }
                _ => own,
            };
            all.push((own, column_type, carried));
        }
        Ok(all)
    }

    /// A colour as four floats, the last of which is 1: that there is something.
    pub(super) fn color(&mut self, value: Value, ty: Handle<Type>) -> Result<Value, ShaderError> {
        let columns = Columns::of(self, ty)?;
        if columns.count > 1 {
            return Err(refused("a colour is a number or a vector"));
        }
        let mut parts = Vec::with_capacity(4);
        for row in 0..3 {
            let part = match row < columns.rows {
                true if columns.rows > 1 => self.member(value, row),
                true => value,
                false => self.number(0.0),
            };
            parts.push(match columns.scalar.kind {
                kind if row < columns.rows && kind != ScalarKind::Float => {
                    self.value(Expression::As { expr: part, kind: ScalarKind::Float, convert: Some(4) })
                }
                _ => part,
            });
        }
        parts.push(self.number(1.0));
        let ty = self.ty(TypeInner::Vector { size: VectorSize::Quad, scalar: Scalar::F32 });
        Ok(self.compose(ty, parts))
    }

    /// Returns members as a struct; gives its type and its value.
    pub(super) fn output(
        &mut self,
        members: Vec<(String, Value, Handle<Type>, Binding)>,
    ) -> (Handle<Type>, Value) {
        let (mut offset, mut all, mut values) = (0, Vec::new(), Vec::new());
        for (name, value, ty, binding) in members {
            let bytes = match self.module.types[ty].inner {
                TypeInner::Vector { size, .. } => 4 * size as u32,
                _ => 4,
            };
            let alignment = if bytes == 12 { 16 } else { bytes };
            offset = u32::next_multiple_of(offset, alignment);
            all.push(StructMember { name: Some(name), ty, binding: Some(binding), offset });
            values.push(value);
            offset += bytes;
        }
        let inner = TypeInner::Struct { members: all, span: offset.next_multiple_of(16) };
        let output = Type { name: Some("GlanzOutput".to_owned()), inner };
        let ty = self.module.types.insert(output, naga::Span::UNDEFINED);
        (ty, self.compose(ty, values))
    }

    /// An argument that the pipeline gives.
    pub(super) fn of_pipeline(&mut self, builtin: BuiltIn, ty: Handle<Type>) -> Value {
        let binding = Some(Binding::BuiltIn(builtin));
        self.argument(FunctionArgument { name: Some("given".to_owned()), ty, binding })
    }
}
