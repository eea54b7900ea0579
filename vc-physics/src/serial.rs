//! Serialisation of poses and places of other crates in snapshots.

/// A pose as seven numbers.
pub(crate) mod pose {
    use nalgebra::{Quaternion, Translation3, Unit};
    use serde::{Deserialize, Deserializer, Serialize, Serializer};
    use vc_graph::Pose;

    pub(crate) fn serialize<S: Serializer>(pose: &Pose, to: S) -> Result<S::Ok, S::Error> {
        let (t, q) = (pose.translation.vector, pose.rotation.coords);
        [t.x, t.y, t.z, q.x, q.y, q.z, q.w].serialize(to)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Pose, D::Error> {
        let [x, y, z, i, j, k, w] = <[f32; 7]>::deserialize(from)?;
        // The quaternion is not normalised, so that its bits stay the same.
        Ok(Pose::from_parts(Translation3::new(x, y, z), Unit::new_unchecked(Quaternion::new(w, i, j, k))))
    }
}

/// A place as its relation and its node.
pub(crate) mod place {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};
    use vc_graph::{NodeId, Place, Relation};

    pub(crate) fn serialize<S: Serializer>(place: &Option<Place>, to: S) -> Result<S::Ok, S::Error> {
        place.map(|p| (p.relation, p.at)).serialize(to)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Place>, D::Error> {
        let place = <Option<(Relation, NodeId)>>::deserialize(from)?;
        Ok(place.map(|(relation, at)| Place { relation, at }))
    }
}
