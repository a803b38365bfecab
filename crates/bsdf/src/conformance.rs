//! The laws, instantiated for every model by the list.

macro_rules! suite {
    ($model:ty) => {
        #[test]
        fn has_a_name() {
            assert!(!<$model as crate::Model>::INFO.name.is_empty());
        }
    };
}
pub(crate) use suite;
