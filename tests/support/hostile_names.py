"""Names that languages, headers, TeX, YAML and mechc's own code have, and names that are alike."""

MANY = """
    auto break char const continue default do enum extern for goto if long register return short
    signed sizeof static struct switch typedef union unsigned void volatile while asm fortran
    alignof false true typeof_unqual and_eq bitand bitor compl not not_eq or or_eq xor xor_eq catch
    const_cast dynamic_cast explicit export friend mutable namespace noexcept operator private
    protected public reinterpret_cast static_cast throw try typeid using virtual wchar_t char8_t
    char16_t co_await co_yield co_return concept requires decltype final override import module
    False async await del elif except finally global is nonlocal pass raise with yield isinstance
    object property super zip map filter id hash dict list set tuple str bytes open input eval exec
    compile format vars dir iter next round divmod slice ValueError Exception NotImplemented
    Ellipsis var function instanceof arguments undefined NaN Infinity debugger acosh erf erfc exp2
    expm1 fdim fma fmax fmin fmod frexp ilogb j0 j1 yn tgamma log1p log2 logb modf nan nearbyint
    remainder rint scalbn trunc isfinite isinf isnormal isgreater FP_INFINITE FP_ZERO FP_ILOGB0
    MATH_ERREXCEPT M_PI_2 M_LN2 M_SQRT2 M_1_PI HUGE_VALF INT8_MAX INT_FAST8_MAX INTPTR_MAX UINT8_C
    UINT64_C WCHAR_MAX int8_t int64_t uint32_t uintptr_t intmax_t PRId32 SCNu8 EILSEQ EACCES EAGAIN
    EINTR EINVAL ENOMEM EPERM cimag cabs cexp stdout stderr printf malloc memset strlen exit atexit
    getenv system rand clock signal jmp_buf setjmp va_list huge interface small pascal cdecl
    STDCALL TRUE FALSE BOOL DWORD ERROR IN OUT OPTIONAL CONST VOID main rindex link2 tzname
    mechc_cos mechc_solve MECHC_ALLOW_FAST_MATH toggle toggle_k toggle_pose toggle_defaults
    toggle_parameters toggle_points k k_n k_of k_n_of k_gradient pose points defaults parameters j
    values out x y z t row column pivot2 names begin2 end2 hbox textbf sqrt2 cdot prime mathrm
    omega alpha1 varepsilon varphi theta vartheta Omega Gamma hbar ell imath partial nabla infty_
    Re Im yes no off y_ n_ Yes NO null Null none aA Aa AA aa a_A x1y2 a1b2c3 l_l ll_ L_ q__r s___t
    E2e M_x e e1 e10 E10 d1 f1 u8 L1 LL ul ULL kg_ mm_ deg_ rad_ N_m s_ h_ min_ max_ lim det dim
    gcd Pr w' w'' x0'
"""
"""Beside those of ``emit/test_hostile_names.py``: words of C, C++, Python, JavaScript and YAML,
macros and functions of the headers, what emitted code and LaTeX call things, names that differ
in a capital, a prime or an underscore alone."""

LONG = ("a" * 200, "b_" * 90 + "z")

HOSTILE = [*MANY.split(), *LONG]
