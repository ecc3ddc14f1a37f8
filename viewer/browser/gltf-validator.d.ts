declare module "gltf-validator" {
  interface Report {
    issues: { messages: { code: string; message: string; severity: number; pointer: string }[] };
    info: { animationCount: number };
  }
  const validator: { validateBytes(data: Uint8Array): Promise<Report> };
  export default validator;
}
