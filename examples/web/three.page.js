// Three objects of two materials on a floor: what examples/web/three.html shows.
const $ = id => document.getElementById(id);
const renderer = new THREE.WebGLRenderer({ antialias: true });
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(30, 1, 0.5, 50), lamp = new THREE.DirectionalLight(0xfff1e0, 5);
renderer.shadowMap.enabled = true;
renderer.toneMapping = THREE.ACESFilmicToneMapping;
document.body.append(renderer.domElement);
lamp.castShadow = true;
lamp.shadow.mapSize.set(1024, 1024);
lamp.shadow.normalBias = 0.02;
Object.assign(lamp.shadow.camera, { left: -4, right: 4, top: 4, bottom: -4, near: 1, far: 20 });
scene.background = new THREE.Color(0x2a2f3a);
scene.add(lamp, new THREE.HemisphereLight(0x99aacc, 0x665544, 0.5));
const solid = (color, roughness) => new THREE.MeshStandardMaterial({ color, roughness });
const skin = solid(0xc58c6e, 0.45), marble = solid(0xe9e4da, 0.3), floor = solid(0x6a7078, 0.8);
const add = (geometry, material, x, y, z) => {
  const mesh = new THREE.Mesh(geometry, material);
  mesh.position.set(x, y, z);
  mesh.castShadow = mesh.receiveShadow = true;
  scene.add(mesh);
  return mesh;
};
const face = new THREE.SphereGeometry(1, 384, 256), p = face.attributes.position; // a ball with folds
for (let i = 0; i < p.count; ++i) {
  const [x, y, z] = [p.getX(i), p.getY(i), p.getZ(i)], s = 1 + 0.05 * Math.sin(9 * x + 2 * y) * Math.sin(8 * y) + 0.03 * Math.sin(17 * z);
  p.setXYZ(i, s * x, s * y, s * z);
}
face.computeVertexNormals();
add(face, skin, -2.1, 0, 0);
add(new THREE.TorusKnotGeometry(0.75, 0.25, 256, 48), marble, 0.2, 0.05, 0);
for (const part of [[[0.02, -1], [0.6, -0.85], [0.95, -0.3], [1, 0.6]], [[1, 0.6], [0.95, 0.6]], [[0.95, 0.6], [0.9, -0.28], [0.55, -0.78], [0.02, -0.93]]])
  add(new THREE.LatheGeometry(part.map(q => new THREE.Vector2(...q)), 128), marble, 2.4, 0, 0); // a cup: outside, rim, inside, whose normals differ at the edges
add(new THREE.PlaneGeometry(30, 30), floor, 0, -1.1, 0).rotation.x = -Math.PI / 2;
const { MeshBasicMaterial, MeshStandardMaterial } = THREE;
const view = window.view = { THREE: { MeshBasicMaterial, MeshStandardMaterial }, scene, camera, azimuth: 0.3, height: 0.25, ready: false };
const pose = () => {
  const a = $('turn').value * Math.PI / 180;
  lamp.position.set(9 * Math.sin(a), 5, 9 * Math.cos(a));
  camera.position.set(9 * Math.sin(view.azimuth) * Math.cos(view.height), 9 * Math.sin(view.height), 9 * Math.cos(view.azimuth) * Math.cos(view.height));
  camera.lookAt(0, -0.1, 0);
};
const widest = 12 / 40 / (2 * 9 * Math.tan(15 * Math.PI / 180)) * innerHeight * devicePixelRatio; // 12 mm of 40 mm a unit, 9 units away
const sss = await Subsurface.create(renderer, [
  { reflectance: [0.44, 0.22, 0.13], path: [1.8, 1.2, 0.73] },
  { reflectance: [0.83, 0.79, 0.75], path: [0.41, 0.66, 1.03] }], { mmPerUnit: 40, radius: Math.min(widest, 150) });
sss.apply(skin, 0);
sss.apply(marble, 1);
view.sss = sss;
view.draw = () => {
  pose();
  sss.lamp = $('thin').checked ? lamp : null;
  sss.enabled = $('scatter').checked;
  sss.render(scene, camera);
  renderer.render(scene, camera);
};
const resize = () => {
  renderer.setPixelRatio(devicePixelRatio);
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  view.draw();
};
for (const id of ['scatter', 'thin', 'turn']) $(id).oninput = view.draw;
renderer.domElement.onpointermove = e => {
  if (!e.buttons) return;
  view.azimuth -= 0.008 * e.movementX;
  view.height = Math.min(1.2, Math.max(-0.1, view.height + 0.008 * e.movementY));
  view.draw();
};
addEventListener('resize', resize);
resize();
$('message').textContent = 'Skin, and marble twice, by sss_three.js. Drag to turn; untick "scatter" for three.js alone.';
view.ready = true;
