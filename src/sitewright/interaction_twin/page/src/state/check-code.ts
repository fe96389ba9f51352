// The first 40 bits of a fingerprint for the eye, in Crockford's base32; the same as everywhere else.

const DIGITS = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";

export function checkCode(fingerprint: string): string {
  let value = BigInt(`0x${fingerprint.slice(0, 10)}`);
  let code = "";
  for (let place = 0; place < 8; place += 1) {
    code = (DIGITS[Number(value & 31n)] ?? "") + code;
    value >>= 5n;
  }
  return `${code.slice(0, 4)}-${code.slice(4)}`;
}
