//! Instructions.

/// What an instruction does. `F`, `I`, `U`, `B` say how it takes the 32 bits of a lane: float, signed, unsigned, truth
/// value (all bits or none).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub(crate) enum Code {
    Mov,
    FAdd,
    FSub,
    FMul,
    FDiv,
    FMod,
    FNeg,
    FAbs,
    FMin,
    FMax,
    FFloor,
    FCeil,
    FFract,
    FTrunc,
    FRound,
    FSign,
    FSqrt,
    FRsqrt,
    FExp2,
    FLog2,
    FPow,
    FSin,
    FCos,
    FTan,
    FAcos,
    FAsin,
    FAtan,
    FAtan2,
    /// a · b + c, rounded twice.
    FMad,
    FMix,
    FClamp,
    FStep,
    FSmooth,
    FLt,
    FLe,
    FGt,
    FGe,
    FEq,
    FNe,
    IAdd,
    ISub,
    IMul,
    IDiv,
    IMod,
    INeg,
    IAbs,
    ISign,
    IMin,
    IMax,
    ILt,
    ILe,
    IGt,
    IGe,
    IEq,
    INe,
    UDiv,
    UMod,
    ULt,
    ULe,
    UMin,
    UMax,
    And,
    Or,
    Xor,
    Not,
    AndNot,
    Shl,
    ShrI,
    ShrU,
    CountOnes,
    ReverseBits,
    LeadingZeros,
    TrailingZeros,
    /// c ? a : b
    Sel,
    FToI,
    FToU,
    IToF,
    UToF,
    BToF,
    BToI,
    Dot,
    Length,
    Normalize,
    Cross,
    /// The word `imm` in every lane.
    Imm,
    /// `n` words of the uniforms from `imm` on.
    LoadU,
    /// `n` words of the uniforms from `imm + min(a, b) · c` on; bit 3 of `s`: a is the same in all lanes.
    LoadUI,
    DdX,
    DdY,
    /// A look into a texture: entry `imm` of the table of looks; the texel goes to `d`.
    Texture,
    /// To instruction `imm`.
    Jump,
    /// To instruction `imm` if no lane of a holds.
    JumpNone,
    /// To instruction `imm` if any lane of a holds.
    JumpAny,
    /// One turn of a loop; ends the run when the fuel is used up.
    Count,
    /// Event `imm` of the trace.
    Note,
}

impl Code {
    /// Whether the instruction directs the run and writes no register.
    pub(crate) fn is_control(self) -> bool {
        matches!(self, Self::Jump | Self::JumpNone | Self::JumpAny | Self::Count | Self::Note)
    }

    /// How many of a, b, c are registers.
    pub(crate) fn operands(self) -> usize {
        use Code::{
            BToF, BToI, CountOnes, DdX, DdY, FAbs, FAcos, FAsin, FAtan, FCeil, FClamp, FCos, FExp2, FFloor,
            FFract, FLog2, FMad, FMix, FNeg, FRound, FRsqrt, FSign, FSin, FSmooth, FSqrt, FTan, FToI, FToU,
            FTrunc, IAbs, INeg, ISign, IToF, JumpAny, JumpNone, LeadingZeros, Length, LoadUI, Mov, Normalize,
            Not, ReverseBits, Sel, TrailingZeros, UToF,
        };
        match self {
            Self::LoadU | Self::Imm | Self::Jump | Self::Count | Self::Note | Self::Texture => 0,
            Mov | FNeg | FAbs | FFloor | FCeil | FFract | FTrunc | FRound | FSign | FSqrt | FRsqrt
            | FExp2 | FLog2 | FSin | FCos | FTan | FAcos | FAsin | FAtan | INeg | IAbs | ISign | Not
            | FToI | FToU | IToF | UToF | BToF | BToI | Length | Normalize | LoadUI | DdX | DdY
            | JumpNone | JumpAny | CountOnes | ReverseBits | LeadingZeros | TrailingZeros => 1,
            FMad | FMix | FClamp | FSmooth | Sel => 3,
            _ => 2,
        }
    }
}

/// One instruction: `n` components; bits 0 to 2 of `s` say which of a, b, c move on with the component.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Op {
    pub(crate) code: Code,
    pub(crate) s: u8,
    pub(crate) n: u16,
    pub(crate) d: u16,
    pub(crate) a: u16,
    pub(crate) b: u16,
    pub(crate) c: u16,
    pub(crate) imm: u32,
}
