/**
 * Skins of more than four joints a vertex, of which three.js knows the first four: places and normals that those four put where all of
 * them would, as the model rests. An animation moves them by those four.
 */
import {
  BufferAttribute,
  BufferGeometry,
  type InterleavedBufferAttribute,
  Matrix3,
  Matrix4,
  type Object3D,
  SkinnedMesh,
  Vector3,
} from "three";

/** The first four's weights as the file has them: three.js makes its own add up to one. `plainGeometry` adds them. */
export const OWN_WEIGHTS = "_WEIGHTS_0";

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Changes the geometry of those meshes below `root` that have such a skin. */
export function settleSkins(root: Object3D): void {
  root.updateMatrixWorld(true);
  root.traverse((object) => {
    if (object instanceof SkinnedMesh && object.geometry.hasAttribute(OWN_WEIGHTS.toLowerCase())) settle(object);
  });
}

function settle(mesh: SkinnedMesh): void {
  const { attributes, index, morphAttributes, morphTargetsRelative } = mesh.geometry;
  const geometry = Object.assign(new BufferGeometry(), { index, morphAttributes, morphTargetsRelative });
  // Meshes share geometry, and each has joints of its own.
  mesh.geometry = Object.assign(geometry, { attributes: { ...attributes } });
  const palette = mesh.skeleton.bones.map((bone, joint) =>
    new Matrix4().multiplyMatrices(bone.matrixWorld, mesh.skeleton.boneInverses[joint] as Matrix4),
  );
  const sets: [joints: Attribute, weights: Attribute][] = [];
  for (let set = 0; ; set++) {
    const joints = attributes[set === 0 ? "skinIndex" : `joints_${set}`];
    const weights = attributes[set === 0 ? OWN_WEIGHTS.toLowerCase() : `weights_${set}`];
    if (joints === undefined || weights === undefined) break;
    sets.push([joints as Attribute, weights as Attribute]);
  }
  const four = [[attributes.skinIndex as Attribute, attributes.skinWeight as Attribute]] as const;
  const places = writable(geometry, "position") as BufferAttribute;
  const normals = writable(geometry, "normal");
  const [shown, wanted, place, moved] = [new Matrix4(), new Matrix4(), new Vector3(), new Vector3()];
  const turn = new Matrix3();
  for (let vertex = 0; vertex < places.count; vertex++) {
    blend(palette, sets, vertex, wanted);
    blend(palette, four, vertex, shown);
    if (shown.determinant() === 0) continue;
    if (normals !== null) {
      morph(mesh, "normal", vertex, moved.set(0, 0, 0));
      place.fromBufferAttribute(normals, vertex).add(moved).applyMatrix3(turn.getNormalMatrix(wanted));
      // An inverse transpose's own inverse.
      place.applyMatrix3(turn.setFromMatrix4(shown).transpose()).normalize().sub(moved);
      normals.setXYZ(vertex, place.x, place.y, place.z);
    }
    morph(mesh, "position", vertex, moved.set(0, 0, 0));
    place.fromBufferAttribute(places, vertex).add(moved).applyMatrix4(wanted).applyMatrix4(shown.invert()).sub(moved);
    places.setXYZ(vertex, place.x, place.y, place.z);
  }
}

/** A copy of the attribute in floats, in its place; null where there is none. */
function writable(geometry: BufferGeometry, name: string): BufferAttribute | null {
  const own = geometry.attributes[name] as Attribute | undefined;
  if (own === undefined) return null;
  const vector = new Vector3();
  const copy = new BufferAttribute(new Float32Array(own.count * 3), 3);
  for (let vertex = 0; vertex < own.count; vertex++)
    vector.fromBufferAttribute(own, vertex).toArray(copy.array, vertex * 3);
  geometry.setAttribute(name, copy);
  return copy;
}

/** The joints' matrices by their weights, made to add up to one. */
function blend(
  palette: readonly Matrix4[],
  sets: readonly (readonly [joints: Attribute, weights: Attribute])[],
  vertex: number,
  target: Matrix4,
): void {
  const sum = target.elements.fill(0);
  let total = 0;
  for (const [joints, weights] of sets) {
    for (let influence = 0; influence < 4; influence++) {
      const weight = weights.getComponent(vertex, influence);
      const joint = palette[joints.getComponent(vertex, influence)];
      if (joint === undefined || weight === 0) continue;
      total += weight;
      for (const [element, value] of joint.elements.entries()) sum[element] = (sum[element] as number) + weight * value;
    }
  }
  if (total === 0) target.copy(palette[0] as Matrix4);
  else target.multiplyScalar(1 / total);
}

/** Adds what the morph targets move a vertex by at rest. */
function morph(mesh: SkinnedMesh, name: "position" | "normal", vertex: number, target: Vector3): void {
  const offset = new Vector3();
  for (const [index, attribute] of (mesh.geometry.morphAttributes[name] ?? []).entries()) {
    target.addScaledVector(offset.fromBufferAttribute(attribute, vertex), mesh.morphTargetInfluences?.[index] ?? 0);
  }
}
