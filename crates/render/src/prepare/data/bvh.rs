//! The triangles that cast shadows, in a bounding volume hierarchy.

use glam::Vec3A;

/// How far from a surface a ray starts, so that it does not meet that surface, and how near to a triangle's plane it does not
/// meet that triangle: some tens of times the rounding in `f32` of the coordinates of point and corners, in parts of them.
const OFFSET: f32 = 3e-6;

/// Nodes that wait on the stack of a ray; deeper trees go on by recursion.
const STACK: usize = 96;

/// A node of the tree.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BvhNode {
    /// The least corner of its box.
    pub min: [f32; 3],
    /// The greatest corner of its box.
    pub max: [f32; 3],
    /// Of a leaf the first of its triangles, of an inner node the first of its two children, which stand together.
    pub first: u32,
    /// The number of triangles of a leaf; 0 for inner nodes.
    pub count: u32,
}

/// All opaque triangles of the scene, relative to a point of the world.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bvh {
    /// The point of the world that everything is relative to.
    pub center: [f64; 3],
    /// A corner and the two edges from it, in the order of the leaves.
    pub triangles: Vec<[[f32; 3]; 3]>,
    /// The nodes, the root first; none where nothing casts a shadow.
    pub nodes: Vec<BvhNode>,
    /// The diagonal of the box around everything.
    pub size: f32,
}

/// A line from a surface towards a light.
struct Ray {
    origin: Vec3A,
    direction: Vec3A,
    /// The inverse of each component of the direction, finite.
    inverse: Vec3A,
    end: f32,
}

impl Bvh {
    /// Whether nothing is between a point of a surface, off it by so much at most and with this normal (towards the
    /// light's side), and a light in this unit direction, at this distance.
    pub fn is_unoccluded(
        &self,
        (point, off): ([f32; 3], f32),
        normal: [f32; 3],
        towards: [f32; 3],
        distance: f32,
    ) -> bool {
        let Some(root) = self.nodes.first() else { return true };
        let point = Vec3A::from_array(point);
        let offset = point.length() * OFFSET + off;
        let origin = point + Vec3A::from_array(normal) * offset;
        let direction = Vec3A::from_array(towards);
        let is_number = origin.is_finite() && direction.is_finite() && direction.length_squared() > 0.5;
        if !is_number {
            return true;
        }
        // Infinite distances stop beyond the scene; what is farther cannot be there.
        let end = (distance - offset).min(4.0 * (self.size + origin.length()));
        if end <= 0.0 {
            return true;
        }
        let inverse = Vec3A::from_array(towards.map(finite_inverse));
        let ray = Ray { origin, direction, inverse, end };
        !(root.is_met_by(&ray) && self.blocks(root, &ray))
    }

    /// Whether a triangle below a node, whose box the ray meets, is in the way.
    fn blocks(&self, node: &BvhNode, ray: &Ray) -> bool {
        let (mut stack, mut waiting) = ([0u32; STACK], 0);
        let mut node = node;
        loop {
            if node.count > 0 {
                let triangles = &self.triangles[node.first as usize..][..node.count as usize];
                if triangles.iter().any(|triangle| ray.meets(triangle)) {
                    return true;
                }
            } else {
                let children = &self.nodes[node.first as usize..][..2];
                match (children[0].is_met_by(ray), children[1].is_met_by(ray)) {
                    (true, both) => {
                        if both && waiting < STACK {
                            stack[waiting] = node.first + 1;
                            waiting += 1;
                        } else if both && self.blocks(&children[1], ray) {
                            return true;
                        }
                        node = &children[0];
                        continue;
                    }
                    (false, true) => {
                        node = &children[1];
                        continue;
                    }
                    (false, false) => {}
                }
            }
            if waiting == 0 {
                return false;
            }
            waiting -= 1;
            node = &self.nodes[stack[waiting] as usize];
        }
    }
}

impl BvhNode {
    /// Whether a ray meets the box before its end.
    fn is_met_by(&self, ray: &Ray) -> bool {
        let t1 = (Vec3A::from_array(self.min) - ray.origin) * ray.inverse;
        let t2 = (Vec3A::from_array(self.max) - ray.origin) * ray.inverse;
        let (enters, leaves) = (t1.min(t2).max_element(), t1.max(t2).min_element());
        leaves >= enters && leaves >= 0.0 && enters < ray.end
    }
}

/// 1 / x, or the greatest number where that is infinite.
fn finite_inverse(x: f32) -> f32 {
    if x.abs() <= f32::EPSILON { f32::EPSILON.recip().copysign(x) } else { x.recip() }
}

impl Ray {
    /// Whether it meets a triangle before its end. Source: T. Möller and B. Trumbore, "Fast, Minimum Storage
    /// Ray-Triangle Intersection", Journal of Graphics Tools 2(1), 1997.
    fn meets(&self, triangle: &[[f32; 3]; 3]) -> bool {
        let [corner, first, second] = triangle.map(Vec3A::from_array);
        let p = self.direction.cross(second);
        let determinant = first.dot(p);
        if determinant == 0.0 {
            return false;
        }
        let inverse = 1.0 / determinant;
        let from = self.origin - corner;
        let u = from.dot(p) * inverse;
        let q = from.cross(first);
        let v = self.direction.dot(q) * inverse;
        let t = second.dot(q) * inverse;
        if !(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < self.end) {
            return false;
        }
        // Large triangles and those far from the middle may be off by more than the ray's start is: what lies on their planes
        // does not meet them.
        let normal = first.cross(second);
        let extent = corner.abs().max(first.abs()).max(second.abs()).max_element();
        (t * determinant).abs() > OFFSET * extent * normal.length()
    }
}
