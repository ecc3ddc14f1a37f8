/** What the tests use of MathJax, which comes without types. */
declare module "mathjax" {
  const MathJax: {
    init(settings: object): Promise<unknown>;
    tex2mml(tex: string, options: { display: boolean }): string;
  };
  export default MathJax;
}
