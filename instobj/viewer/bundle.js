// made from 653b2c7620467d80dd8a04cd2f2255f3cc94ed94ba83978982dfbfd4145a580e
var instobjViewer=(()=>{var Jh=Object.defineProperty;var r_=Object.getOwnPropertyDescriptor;var o_=Object.getOwnPropertyNames;var a_=Object.prototype.hasOwnProperty;var l_=(i,e)=>{for(var t in e)Jh(i,t,{get:e[t],enumerable:!0})},c_=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of o_(e))!a_.call(i,s)&&s!==t&&Jh(i,s,{get:()=>e[s],enumerable:!(n=r_(e,s))||n.enumerable});return i};var h_=i=>c_(Jh({},"__esModule",{value:!0}),i);var A1={};l_(A1,{render:()=>T1});var u_={i1:Int8Array,u1:Uint8Array,i2:Int16Array,u2:Uint16Array,u4:Uint32Array,f4:Float32Array};function Ja(i){return Uint8Array.from(atob(i.trim()),e=>e.charCodeAt(0))}async function Ds(i){let e=new Blob([i]).stream().pipeThrough(new DecompressionStream("gzip")),t=await new Response(e).arrayBuffer(),n=new DataView(t).getUint32(0,!0),s=JSON.parse(new TextDecoder().decode(new Uint8Array(t,4,n))),r={};for(let[o,a]of Object.entries(s.arrays)){let l=a.shape.reduce((f,h)=>f*h,1),c=new u_[a.kind](t,4+n+a.at,l),u={i1:127,i2:32767}[a.kind];r[o]={data:c,shape:a.shape,step:a.step,none:a.gaps?u:null}}return{content:s,arrays:r}}function Cn(i){return Float32Array.from(i.data,e=>e===i.none?NaN:e*i.step)}function pn(i,e,t){let n=[];for(let s=e*t;s<(e+1)*t;s++)n.push(i.data[s]*i.step);return n}var Xs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},qs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},hp=0,Cu=1,up=2;var Sa=1,fp=2,co=3,Ys=0,On=1,yi=2,cr=0,ho=1,Ru=2,Pu=3,Iu=4,dp=5;var hr=100,pp=101,mp=102,gp=103,_p=104,xp=200,yp=201,vp=202,Sp=203,Lu=204,Du=205,Mp=206,bp=207,wp=208,Ep=209,Tp=210,Ap=211,Cp=212,Rp=213,Pp=214,Cl=0,Rl=1,Pl=2,jr=3,Il=4,Ll=5,Dl=6,Nl=7,oc=0,Ip=1,Lp=2,Qi=0,Nu=1,Uu=2,Ou=3,Fu=4,Bu=5,ku=6,zu=7;var Vu=300,ur=301,uo=302,ac=303,lc=304,Ul=1e3,Ji=1001,Ol=1002,In=1003,Dp=1004;var Ma=1005;var Nn=1006,cc=1007;var vs=1008;var Qn=1009,Gu=1010,Hu=1011,fo=1012,hc=1013,Di=1014,vi=1015,Ni=1016,uc=1017,fc=1018,fr=1020,Wu=35902,Xu=35899,qu=1021,Yu=1022,Ui=1023,ms=1026,Ss=1027,dc=1028,pc=1029,$s=1030,mc=1031;var gc=1033,ba=33776,wa=33777,Ea=33778,Ta=33779,_c=35840,xc=35841,yc=35842,vc=35843,Sc=36196,Mc=37492,bc=37496,wc=37488,Ec=37489,Aa=37490,Tc=37491,Ac=37808,Cc=37809,Rc=37810,Pc=37811,Ic=37812,Lc=37813,Dc=37814,Nc=37815,Uc=37816,Oc=37817,Fc=37818,Bc=37819,kc=37820,zc=37821,Vc=36492,Gc=36494,Hc=36495,Wc=36283,Xc=36284,Ca=36285,qc=36286;var $o=2300,Fl=2301,Tl=2302,vu=2303,Su=2400,Mu=2401,bu=2402;var Np=3200;var Yc=0,Up=1,Ms="",Vn="srgb",Zo="srgb-linear",Jo="linear",It="srgb";var Al=7680;var Op=519,Fp=512,Bp=513,kp=514,$u=515,zp=516,Vp=517,Zu=518,Ju=519,Ku=35044;var ju="300 es",mi=2e3,Qr=2001;function f_(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function d_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ko(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Gp(){let i=Ko("canvas");return i.style.display="block",i}var Rd={},eo=null;function jo(...i){let e="THREE."+i.shift();eo?eo("log",e,...i):console.log(e,...i)}function Hp(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function nt(...i){i=Hp(i);let e="THREE."+i.shift();if(eo)eo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function rt(...i){i=Hp(i);let e="THREE."+i.shift();if(eo)eo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function qo(...i){let e=i.join(" ");e in Rd||(Rd[e]=!0,nt(...i))}function Wp(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Xp={[Cl]:Cl,[Pl]:Dl,[Il]:Il,[jr]:Ll,[Rl]:Rl,[Dl]:Pl,[Nl]:Nl,[Ll]:jr},Ii=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},kn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Pd=1234567,Jr=Math.PI/180,to=180/Math.PI;function Zs(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(kn[i&255]+kn[i>>8&255]+kn[i>>16&255]+kn[i>>24&255]+"-"+kn[e&255]+kn[e>>8&255]+"-"+kn[e>>16&15|64]+kn[e>>24&255]+"-"+kn[t&63|128]+kn[t>>8&255]+"-"+kn[t>>16&255]+kn[t>>24&255]+kn[n&255]+kn[n>>8&255]+kn[n>>16&255]+kn[n>>24&255]).toLowerCase()}function yt(i,e,t){return Math.max(e,Math.min(t,i))}function Qu(i,e){return(i%e+e)%e}function p_(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function m_(i,e,t){return i!==e?(t-i)/(e-i):0}function Yo(i,e,t){return(1-t)*i+t*e}function g_(i,e,t,n){return Yo(i,e,1-Math.exp(-t*n))}function __(i,e=1){return e-Math.abs(Qu(i,e*2)-e)}function x_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function y_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function v_(i,e){return i+Math.floor(Math.random()*(e-i+1))}function S_(i,e){return i+Math.random()*(e-i)}function M_(i){return i*(.5-Math.random())}function b_(i){i!==void 0&&(Pd=i);let e=Pd+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function w_(i){return i*Jr}function E_(i){return i*to}function T_(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function A_(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function ef(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function C_(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),f=r((e-n)/2),h=o((e-n)/2),d=r((n-e)/2),m=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*f,l*h,a*c);break;case"YZY":i.set(l*h,a*u,l*f,a*c);break;case"ZXZ":i.set(l*f,l*h,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*d,a*c);break;case"YXY":i.set(l*d,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*d,a*u,a*c);break;default:nt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function $c(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function tf(i,e){if(e.constructor===Float32Array)return i;let t=$c(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function nf(i,e){if(e.constructor===Float32Array)return i;let t=$c(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var sf={DEG2RAD:Jr,RAD2DEG:to,generateUUID:Zs,clamp:yt,euclideanModulo:Qu,mapLinear:p_,inverseLerp:m_,lerp:Yo,damp:g_,pingpong:__,smoothstep:x_,smootherstep:y_,randInt:v_,randFloat:S_,randFloatSpread:M_,seededRandom:b_,degToRad:w_,radToDeg:E_,isPowerOfTwo:T_,ceilPowerOfTwo:A_,floorPowerOfTwo:ef,setQuaternionFromProperEuler:C_,normalize:nf,denormalize:tf},Je=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},cn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],f=n[s+3],h=r[o+0],d=r[o+1],m=r[o+2],_=r[o+3];if(f!==_||l!==h||c!==d||u!==m){let g=l*h+c*d+u*m+f*_;g<0&&(h=-h,d=-d,m=-m,_=-_,g=-g);let p=1-a;if(g<.9995){let y=Math.acos(g),R=Math.sin(y);p=Math.sin(p*y)/R,a=Math.sin(a*y)/R,l=l*p+h*a,c=c*p+d*a,u=u*p+m*a,f=f*p+_*a}else{l=l*p+h*a,c=c*p+d*a,u=u*p+m*a,f=f*p+_*a;let y=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=y,c*=y,u*=y,f*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],f=r[o],h=r[o+1],d=r[o+2],m=r[o+3];return e[t]=a*m+u*f+l*d-c*h,e[t+1]=l*m+u*h+c*f-a*d,e[t+2]=c*m+u*d+a*h-l*f,e[t+3]=u*m-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),f=a(r/2),h=l(n/2),d=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*m,this._y=c*d*f-h*u*m,this._z=c*u*m+h*d*f,this._w=c*u*f-h*d*m;break;case"YXZ":this._x=h*u*f+c*d*m,this._y=c*d*f-h*u*m,this._z=c*u*m-h*d*f,this._w=c*u*f+h*d*m;break;case"ZXY":this._x=h*u*f-c*d*m,this._y=c*d*f+h*u*m,this._z=c*u*m+h*d*f,this._w=c*u*f-h*d*m;break;case"ZYX":this._x=h*u*f-c*d*m,this._y=c*d*f+h*u*m,this._z=c*u*m-h*d*f,this._w=c*u*f+h*d*m;break;case"YZX":this._x=h*u*f+c*d*m,this._y=c*d*f+h*u*m,this._z=c*u*m-h*d*f,this._w=c*u*f-h*d*m;break;case"XZY":this._x=h*u*f-c*d*m,this._y=c*d*f-h*u*m,this._z=c*u*m+h*d*f,this._w=c*u*f+h*d*m;break;default:nt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=n+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>f){let d=2*Math.sqrt(1+n-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-n-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Id.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Id.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),f=2*(r*n-o*t);return this.x=t+l*c+o*f-a*u,this.y=n+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Kh.copy(this).projectOnVector(e),this.sub(Kh)}reflect(e){return this.sub(Kh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Kh=new G,Id=new cn,ht=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],f=n[7],h=n[2],d=n[5],m=n[8],_=s[0],g=s[3],p=s[6],y=s[1],R=s[4],S=s[7],b=s[2],M=s[5],x=s[8];return r[0]=o*_+a*y+l*b,r[3]=o*g+a*R+l*M,r[6]=o*p+a*S+l*x,r[1]=c*_+u*y+f*b,r[4]=c*g+u*R+f*M,r[7]=c*p+u*S+f*x,r[2]=h*_+d*y+m*b,r[5]=h*g+d*R+m*M,r[8]=h*p+d*S+m*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,m=t*f+n*h+s*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return e[0]=f*_,e[1]=(s*c-u*n)*_,e[2]=(a*n-s*o)*_,e[3]=h*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=d*_,e[7]=(n*l-c*t)*_,e[8]=(o*t-n*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return qo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(jh.makeScale(e,t)),this}rotate(e){return qo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(jh.makeRotation(-e)),this}translate(e,t){return qo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(jh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},jh=new ht,Ld=new ht().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Dd=new ht().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function R_(){let i={enabled:!0,workingColorSpace:Zo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===It&&(s.r=ps(s.r),s.g=ps(s.g),s.b=ps(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===It&&(s.r=Kr(s.r),s.g=Kr(s.g),s.b=Kr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ms?Jo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Zo]:{primaries:e,whitePoint:n,transfer:Jo,toXYZ:Ld,fromXYZ:Dd,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Vn},outputColorSpaceConfig:{drawingBufferColorSpace:Vn}},[Vn]:{primaries:e,whitePoint:n,transfer:It,toXYZ:Ld,fromXYZ:Dd,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Vn}}}),i}var Mt=R_();function ps(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Kr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Lr,Bl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Lr===void 0&&(Lr=Ko("canvas")),Lr.width=e.width,Lr.height=e.height;let s=Lr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Lr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ko("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ps(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ps(t[n]/255)*255):t[n]=ps(t[n]);return{data:t,width:e.width,height:e.height}}else return nt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},P_=0,no=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:P_++}),this.uuid=Zs(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Qh(s[o].image)):r.push(Qh(s[o]))}else r=Qh(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Qh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Bl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(nt("Texture: Unable to serialize Texture."),{})}var I_=0,eu=new G,Jn=class i extends Ii{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Ji,s=Ji,r=Nn,o=vs,a=Ui,l=Qn,c=i.DEFAULT_ANISOTROPY,u=Ms){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:I_++}),this.uuid=Zs(),this.name="",this.source=new no(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Je(0,0),this.repeat=new Je(1,1),this.center=new Je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ht,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(eu).x}get height(){return this.source.getSize(eu).y}get depth(){return this.source.getSize(eu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){nt(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){nt(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Vu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ul:e.x=e.x-Math.floor(e.x);break;case Ji:e.x=e.x<0?0:1;break;case Ol:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ul:e.y=e.y-Math.floor(e.y);break;case Ji:e.y=e.y<0?0:1;break;case Ol:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Jn.DEFAULT_IMAGE=null;Jn.DEFAULT_MAPPING=Vu;Jn.DEFAULT_ANISOTROPY=1;var Jt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],m=l[9],_=l[2],g=l[6],p=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-_)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+_)<.1&&Math.abs(m+g)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let R=(c+1)/2,S=(d+1)/2,b=(p+1)/2,M=(u+h)/4,x=(f+_)/4,w=(m+g)/4;return R>S&&R>b?R<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(R),s=M/n,r=x/n):S>b?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=M/s,r=w/s):b<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(b),n=x/r,s=w/r),this.set(n,s,r,t),this}let y=Math.sqrt((g-m)*(g-m)+(f-_)*(f-_)+(h-u)*(h-u));return Math.abs(y)<.001&&(y=1),this.x=(g-m)/y,this.y=(f-_)/y,this.z=(h-u)/y,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},kl=class extends Ii{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Nn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Jt(0,0,e,t),this.scissorTest=!1,this.viewport=new Jt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Jn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Nn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new no(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ai=class extends kl{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Qo=class extends Jn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var zl=class extends Jn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Et=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,u,f,h,d,m,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,f,h,d,m,_,g)}set(e,t,n,s,r,o,a,l,c,u,f,h,d,m,_,g){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=f,p[14]=h,p[3]=d,p[7]=m,p[11]=_,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Dr.setFromMatrixColumn(e,0).length(),r=1/Dr.setFromMatrixColumn(e,1).length(),o=1/Dr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,m=a*u,_=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+m*c,t[5]=h-_*c,t[9]=-a*l,t[2]=_-h*c,t[6]=m+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,m=c*u,_=c*f;t[0]=h+_*a,t[4]=m*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-m,t[6]=_+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,m=c*u,_=c*f;t[0]=h-_*a,t[4]=-o*f,t[8]=m+d*a,t[1]=d+m*a,t[5]=o*u,t[9]=_-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,m=a*u,_=a*f;t[0]=l*u,t[4]=m*c-d,t[8]=h*c+_,t[1]=l*f,t[5]=_*c+h,t[9]=d*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,m=a*l,_=a*c;t[0]=l*u,t[4]=_-h*f,t[8]=m*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+m,t[10]=h-_*f}else if(e.order==="XZY"){let h=o*l,d=o*c,m=a*l,_=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+_,t[5]=o*u,t[9]=d*f-m,t[2]=m*f-d,t[6]=a*u,t[10]=_*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(L_,e,D_)}lookAt(e,t,n){let s=this.elements;return ri.subVectors(e,t),ri.lengthSq()===0&&(ri.z=1),ri.normalize(),Ns.crossVectors(n,ri),Ns.lengthSq()===0&&(Math.abs(n.z)===1?ri.x+=1e-4:ri.z+=1e-4,ri.normalize(),Ns.crossVectors(n,ri)),Ns.normalize(),Ka.crossVectors(ri,Ns),s[0]=Ns.x,s[4]=Ka.x,s[8]=ri.x,s[1]=Ns.y,s[5]=Ka.y,s[9]=ri.y,s[2]=Ns.z,s[6]=Ka.z,s[10]=ri.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],f=n[5],h=n[9],d=n[13],m=n[2],_=n[6],g=n[10],p=n[14],y=n[3],R=n[7],S=n[11],b=n[15],M=s[0],x=s[4],w=s[8],F=s[12],I=s[1],T=s[5],D=s[9],L=s[13],P=s[2],B=s[6],H=s[10],z=s[14],oe=s[3],Y=s[7],ee=s[11],ie=s[15];return r[0]=o*M+a*I+l*P+c*oe,r[4]=o*x+a*T+l*B+c*Y,r[8]=o*w+a*D+l*H+c*ee,r[12]=o*F+a*L+l*z+c*ie,r[1]=u*M+f*I+h*P+d*oe,r[5]=u*x+f*T+h*B+d*Y,r[9]=u*w+f*D+h*H+d*ee,r[13]=u*F+f*L+h*z+d*ie,r[2]=m*M+_*I+g*P+p*oe,r[6]=m*x+_*T+g*B+p*Y,r[10]=m*w+_*D+g*H+p*ee,r[14]=m*F+_*L+g*z+p*ie,r[3]=y*M+R*I+S*P+b*oe,r[7]=y*x+R*T+S*B+b*Y,r[11]=y*w+R*D+S*H+b*ee,r[15]=y*F+R*L+S*z+b*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],m=e[3],_=e[7],g=e[11],p=e[15],y=l*d-c*h,R=a*d-c*f,S=a*h-l*f,b=o*d-c*u,M=o*h-l*u,x=o*f-a*u;return t*(_*y-g*R+p*S)-n*(m*y-g*b+p*M)+s*(m*R-_*b+p*x)-r*(m*S-_*M+g*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],m=e[12],_=e[13],g=e[14],p=e[15],y=t*a-n*o,R=t*l-s*o,S=t*c-r*o,b=n*l-s*a,M=n*c-r*a,x=s*c-r*l,w=u*_-f*m,F=u*g-h*m,I=u*p-d*m,T=f*g-h*_,D=f*p-d*_,L=h*p-d*g,P=y*L-R*D+S*T+b*I-M*F+x*w;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/P;return e[0]=(a*L-l*D+c*T)*B,e[1]=(s*D-n*L-r*T)*B,e[2]=(_*x-g*M+p*b)*B,e[3]=(h*M-f*x-d*b)*B,e[4]=(l*I-o*L-c*F)*B,e[5]=(t*L-s*I+r*F)*B,e[6]=(g*S-m*x-p*R)*B,e[7]=(u*x-h*S+d*R)*B,e[8]=(o*D-a*I+c*w)*B,e[9]=(n*I-t*D-r*w)*B,e[10]=(m*M-_*S+p*y)*B,e[11]=(f*S-u*M-d*y)*B,e[12]=(a*F-o*T-l*w)*B,e[13]=(t*T-n*F+s*w)*B,e[14]=(_*R-m*b-g*y)*B,e[15]=(u*b-f*R+h*y)*B,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,m=r*f,_=o*u,g=o*f,p=a*f,y=l*c,R=l*u,S=l*f,b=n.x,M=n.y,x=n.z;return s[0]=(1-(_+p))*b,s[1]=(d+S)*b,s[2]=(m-R)*b,s[3]=0,s[4]=(d-S)*M,s[5]=(1-(h+p))*M,s[6]=(g+y)*M,s[7]=0,s[8]=(m+R)*x,s[9]=(g-y)*x,s[10]=(1-(h+_))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Dr.set(s[0],s[1],s[2]).length(),a=Dr.set(s[4],s[5],s[6]).length(),l=Dr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ci.copy(this);let c=1/o,u=1/a,f=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=u,Ci.elements[5]*=u,Ci.elements[6]*=u,Ci.elements[8]*=f,Ci.elements[9]*=f,Ci.elements[10]*=f,t.setFromRotationMatrix(Ci),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=mi,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(n-s),h=(t+e)/(t-e),d=(n+s)/(n-s),m,_;if(l)m=r/(o-r),_=o*r/(o-r);else if(a===mi)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Qr)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=mi,l=!1){let c=this.elements,u=2/(t-e),f=2/(n-s),h=-(t+e)/(t-e),d=-(n+s)/(n-s),m,_;if(l)m=1/(o-r),_=o/(o-r);else if(a===mi)m=-2/(o-r),_=-(o+r)/(o-r);else if(a===Qr)m=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Dr=new G,Ci=new Et,L_=new G(0,0,0),D_=new G(1,1,1),Ns=new G,Ka=new G,ri=new G,Nd=new Et,Ud=new cn,gs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(yt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(yt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-yt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-yt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:nt("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Nd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Nd,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Ud.setFromEuler(this),this.setFromQuaternion(Ud,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};gs.DEFAULT_ORDER="XYZ";var io=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},N_=0,Od=new G,Nr=new cn,cs=new Et,ja=new G,Oo=new G,U_=new G,O_=new cn,Fd=new G(1,0,0),Bd=new G(0,1,0),kd=new G(0,0,1),zd={type:"added"},F_={type:"removed"},Ur={type:"childadded",child:null},tu={type:"childremoved",child:null},Un=class i extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:N_++}),this.uuid=Zs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new G,t=new gs,n=new cn,s=new G(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Et},normalMatrix:{value:new ht}}),this.matrix=new Et,this.matrixWorld=new Et,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new io,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Nr.setFromAxisAngle(e,t),this.quaternion.multiply(Nr),this}rotateOnWorldAxis(e,t){return Nr.setFromAxisAngle(e,t),this.quaternion.premultiply(Nr),this}rotateX(e){return this.rotateOnAxis(Fd,e)}rotateY(e){return this.rotateOnAxis(Bd,e)}rotateZ(e){return this.rotateOnAxis(kd,e)}translateOnAxis(e,t){return Od.copy(e).applyQuaternion(this.quaternion),this.position.add(Od.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Fd,e)}translateY(e){return this.translateOnAxis(Bd,e)}translateZ(e){return this.translateOnAxis(kd,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(cs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?ja.copy(e):ja.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Oo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?cs.lookAt(Oo,ja,this.up):cs.lookAt(ja,Oo,this.up),this.quaternion.setFromRotationMatrix(cs),s&&(cs.extractRotation(s.matrixWorld),Nr.setFromRotationMatrix(cs),this.quaternion.premultiply(Nr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(rt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(zd),Ur.child=e,this.dispatchEvent(Ur),Ur.child=null):rt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(F_),tu.child=e,this.dispatchEvent(tu),tu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),cs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),cs.multiply(e.parent.matrixWorld)),e.applyMatrix4(cs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(zd),Ur.child=e,this.dispatchEvent(Ur),Ur.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Oo,e,U_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Oo,O_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),m=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),f.length>0&&(n.shapes=f),h.length>0&&(n.skeletons=h),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Un.DEFAULT_UP=new G(0,1,0);Un.DEFAULT_MATRIX_AUTO_UPDATE=!0;Un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Yt=class extends Un{constructor(){super(),this.isGroup=!0,this.type="Group"}},B_={type:"move"},so=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Yt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Yt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Yt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let g=t.getJointPose(_,n),p=this._getHandJoint(c,_);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,m=.005;c.inputState.pinching&&h>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(B_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Yt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},qp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Us={h:0,s:0,l:0},Qa={h:0,s:0,l:0};function nu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ct=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Vn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Mt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Mt.workingColorSpace){return this.r=e,this.g=t,this.b=n,Mt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Mt.workingColorSpace){if(e=Qu(e,1),t=yt(t,0,1),n=yt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=nu(o,r,e+1/3),this.g=nu(o,r,e),this.b=nu(o,r,e-1/3)}return Mt.colorSpaceToWorking(this,s),this}setStyle(e,t=Vn){function n(r){r!==void 0&&parseFloat(r)<1&&nt("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:nt("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);nt("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Vn){let n=qp[e.toLowerCase()];return n!==void 0?this.setHex(n,t):nt("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ps(e.r),this.g=ps(e.g),this.b=ps(e.b),this}copyLinearToSRGB(e){return this.r=Kr(e.r),this.g=Kr(e.g),this.b=Kr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Vn){return Mt.workingToColorSpace(zn.copy(this),e),Math.round(yt(zn.r*255,0,255))*65536+Math.round(yt(zn.g*255,0,255))*256+Math.round(yt(zn.b*255,0,255))}getHexString(e=Vn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Mt.workingColorSpace){Mt.workingToColorSpace(zn.copy(this),t);let n=zn.r,s=zn.g,r=zn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case n:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-n)/f+2;break;case r:l=(n-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Mt.workingColorSpace){return Mt.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=Vn){Mt.workingToColorSpace(zn.copy(this),e);let t=zn.r,n=zn.g,s=zn.b;return e!==Vn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Us),this.setHSL(Us.h+e,Us.s+t,Us.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Us),e.getHSL(Qa);let n=Yo(Us.h,Qa.h,t),s=Yo(Us.s,Qa.s,t),r=Yo(Us.l,Qa.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new ct;ct.NAMES=qp;var ea=class extends Un{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new gs,this.environmentIntensity=1,this.environmentRotation=new gs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ri=new G,hs=new G,iu=new G,us=new G,Or=new G,Fr=new G,Vd=new G,su=new G,ru=new G,ou=new G,au=new Jt,lu=new Jt,cu=new Jt,Zi=class i{constructor(e=new G,t=new G,n=new G){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ri.subVectors(e,t),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ri.subVectors(s,t),hs.subVectors(n,t),iu.subVectors(e,t);let o=Ri.dot(Ri),a=Ri.dot(hs),l=Ri.dot(iu),c=hs.dot(hs),u=hs.dot(iu),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,m=(o*u-a*l)*h;return r.set(1-d-m,m,d)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,us)===null?!1:us.x>=0&&us.y>=0&&us.x+us.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,us)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,us.x),l.addScaledVector(o,us.y),l.addScaledVector(a,us.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return au.setScalar(0),lu.setScalar(0),cu.setScalar(0),au.fromBufferAttribute(e,t),lu.fromBufferAttribute(e,n),cu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(au,r.x),o.addScaledVector(lu,r.y),o.addScaledVector(cu,r.z),o}static isFrontFacing(e,t,n,s){return Ri.subVectors(n,t),hs.subVectors(e,t),Ri.cross(hs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ri.subVectors(this.c,this.b),hs.subVectors(this.a,this.b),Ri.cross(hs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Or.subVectors(s,n),Fr.subVectors(r,n),su.subVectors(e,n);let l=Or.dot(su),c=Fr.dot(su);if(l<=0&&c<=0)return t.copy(n);ru.subVectors(e,s);let u=Or.dot(ru),f=Fr.dot(ru);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(n).addScaledVector(Or,o);ou.subVectors(e,r);let d=Or.dot(ou),m=Fr.dot(ou);if(m>=0&&d<=m)return t.copy(r);let _=d*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(n).addScaledVector(Fr,a);let g=u*m-d*f;if(g<=0&&f-u>=0&&d-m>=0)return Vd.subVectors(r,s),a=(f-u)/(f-u+(d-m)),t.copy(s).addScaledVector(Vd,a);let p=1/(g+_+h);return o=_*p,a=h*p,t.copy(n).addScaledVector(Or,o).addScaledVector(Fr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},gi=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Pi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Pi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Pi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Pi):Pi.fromBufferAttribute(r,o),Pi.applyMatrix4(e.matrixWorld),this.expandByPoint(Pi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),el.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),el.copy(n.boundingBox)),el.applyMatrix4(e.matrixWorld),this.union(el)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Pi),Pi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Fo),tl.subVectors(this.max,Fo),Br.subVectors(e.a,Fo),kr.subVectors(e.b,Fo),zr.subVectors(e.c,Fo),Os.subVectors(kr,Br),Fs.subVectors(zr,kr),nr.subVectors(Br,zr);let t=[0,-Os.z,Os.y,0,-Fs.z,Fs.y,0,-nr.z,nr.y,Os.z,0,-Os.x,Fs.z,0,-Fs.x,nr.z,0,-nr.x,-Os.y,Os.x,0,-Fs.y,Fs.x,0,-nr.y,nr.x,0];return!hu(t,Br,kr,zr,tl)||(t=[1,0,0,0,1,0,0,0,1],!hu(t,Br,kr,zr,tl))?!1:(nl.crossVectors(Os,Fs),t=[nl.x,nl.y,nl.z],hu(t,Br,kr,zr,tl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Pi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Pi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(fs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),fs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),fs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),fs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),fs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),fs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),fs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),fs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(fs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},fs=[new G,new G,new G,new G,new G,new G,new G,new G],Pi=new G,el=new gi,Br=new G,kr=new G,zr=new G,Os=new G,Fs=new G,nr=new G,Fo=new G,tl=new G,nl=new G,ir=new G;function hu(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ir.fromArray(i,r);let a=s.x*Math.abs(ir.x)+s.y*Math.abs(ir.y)+s.z*Math.abs(ir.z),l=e.dot(ir),c=t.dot(ir),u=n.dot(ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var mn=new G,il=new Je,k_=0,Pn=class extends Ii{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:k_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Ku,this.updateRanges=[],this.gpuType=vi,this.version=0,this._normalizationScale=e!==void 0?$c(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)il.fromBufferAttribute(this,t),il.applyMatrix3(e),this.setXY(t,il.x,il.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix3(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix4(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyNormalMatrix(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.transformDirection(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):tf(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):nf(e,this.array)}};var ta=class extends Pn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var na=class extends Pn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var kt=class extends Pn{constructor(e,t,n){super(new Float32Array(e),t,n)}},z_=new gi,Bo=new G,uu=new G,Li=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):z_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Bo.subVectors(e,this.center);let t=Bo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Bo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(uu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Bo.copy(e.center).add(uu)),this.expandByPoint(Bo.copy(e.center).sub(uu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},V_=0,pi=new Et,fu=new Un,Vr=new G,oi=new gi,ko=new gi,Rn=new G,gn=class i extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:V_++}),this.uuid=Zs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(f_(e)?na:ta)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ht().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return pi.makeRotationFromQuaternion(e),this.applyMatrix4(pi),this}rotateX(e){return pi.makeRotationX(e),this.applyMatrix4(pi),this}rotateY(e){return pi.makeRotationY(e),this.applyMatrix4(pi),this}rotateZ(e){return pi.makeRotationZ(e),this.applyMatrix4(pi),this}translate(e,t,n){return pi.makeTranslation(e,t,n),this.applyMatrix4(pi),this}scale(e,t,n){return pi.makeScale(e,t,n),this.applyMatrix4(pi),this}lookAt(e){return fu.lookAt(e),fu.updateMatrix(),this.applyMatrix4(fu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Vr).negate(),this.translate(Vr.x,Vr.y,Vr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new kt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&nt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new gi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];oi.setFromBufferAttribute(r),this.morphTargetsRelative?(Rn.addVectors(this.boundingBox.min,oi.min),this.boundingBox.expandByPoint(Rn),Rn.addVectors(this.boundingBox.max,oi.max),this.boundingBox.expandByPoint(Rn)):(this.boundingBox.expandByPoint(oi.min),this.boundingBox.expandByPoint(oi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&rt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Li);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let n=this.boundingSphere.center;if(oi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ko.setFromBufferAttribute(a),this.morphTargetsRelative?(Rn.addVectors(oi.min,ko.min),oi.expandByPoint(Rn),Rn.addVectors(oi.max,ko.max),oi.expandByPoint(Rn)):(oi.expandByPoint(ko.min),oi.expandByPoint(ko.max))}oi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Rn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Rn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Rn.fromBufferAttribute(a,c),l&&(Vr.fromBufferAttribute(e,c),Rn.add(Vr)),s=Math.max(s,n.distanceToSquared(Rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&rt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){rt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let F=0;F<n.count;F++)a[F]=new G,l[F]=new G;let u=new G,f=new G,h=new G,d=new Je,m=new Je,_=new Je,g=new G,p=new G;function y(F,I,T){c[F]=c[I]=c[T]=1,u.fromBufferAttribute(n,F),f.fromBufferAttribute(n,I),h.fromBufferAttribute(n,T),d.fromBufferAttribute(r,F),m.fromBufferAttribute(r,I),_.fromBufferAttribute(r,T),f.sub(u),h.sub(u),m.sub(d),_.sub(d);let D=1/(m.x*_.y-_.x*m.y);isFinite(D)&&(g.copy(f).multiplyScalar(_.y).addScaledVector(h,-m.y).multiplyScalar(D),p.copy(h).multiplyScalar(m.x).addScaledVector(f,-_.x).multiplyScalar(D),a[F].add(g),a[I].add(g),a[T].add(g),l[F].add(p),l[I].add(p),l[T].add(p))}let R=this.groups;R.length===0&&(R=[{start:0,count:e.count}]);for(let F=0,I=R.length;F<I;++F){let T=R[F],D=T.start,L=T.count;for(let P=D,B=D+L;P<B;P+=3)y(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let S=new G,b=new G,M=new G,x=new G;function w(F){M.fromBufferAttribute(s,F),x.copy(M);let I=a[F];S.copy(I),S.sub(M.multiplyScalar(M.dot(I))).normalize(),b.crossVectors(x,I);let D=b.dot(l[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,D)}for(let F=0,I=n.count;F<I;++F)c[F]&&w(F);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Pn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let h=0,d=n.count;h<d;h++)n.setXYZ(h,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,f=new G;if(e)for(let h=0,d=e.count;h<d;h+=3){let m=e.getX(h+0),_=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,g),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),n.setXYZ(h+0,u.x,u.y,u.z),n.setXYZ(h+1,u.x,u.y,u.z),n.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Rn.fromBufferAttribute(e,t),Rn.normalize(),e.setXYZ(t,Rn.x,Rn.y,Rn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,m=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?d=l[_]*a.data.stride+a.offset:d=l[_]*u;for(let p=0;p<u;p++)h[m++]=c[d++]}return new Pn(h,u,f)}if(this.index===null)return nt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,n);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Vl=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Ku,this.updateRanges=[],this.version=0,this.uuid=Zs()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Gd(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Gd(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Gd(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Zs()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var $n=new G,ia=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?$c(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)$n.fromBufferAttribute(this,t),$n.applyMatrix4(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)$n.fromBufferAttribute(this,t),$n.applyNormalMatrix(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)$n.fromBufferAttribute(this,t),$n.transformDirection(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){jo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Pn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){jo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):tf(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):nf(e,this.data.array)}},du=new G,G_=new G,H_=new ht,Dn=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=du.subVectors(n,t).cross(G_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(du),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||H_.getNormalMatrix(e),s=this.coplanarPoint(du).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},W_=0,Ki=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:W_++}),this.uuid=Zs(),this.name="",this.type="Material",this.blending=ho,this.side=Ys,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Lu,this.blendDst=Du,this.blendEquation=hr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ct(0,0,0),this.blendAlpha=0,this.depthFunc=jr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Op,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Al,this.stencilZFail=Al,this.stencilZPass=Al,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){nt(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){nt(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ct().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Dn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Je().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Je().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},ro=class extends Ki{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ct(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Gr,zo=new G,Hr=new G,Wr=new G,Xr=new Je,Vo=new Je,Yp=new Et,sl=new G,Go=new G,rl=new G,Hd=new Je,pu=new Je,Wd=new Je,sa=class extends Un{constructor(e=new ro){if(super(),this.isSprite=!0,this.type="Sprite",Gr===void 0){Gr=new gn;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new Vl(t,5);Gr.setIndex([0,1,2,0,2,3]),Gr.setAttribute("position",new ia(n,3,0,!1)),Gr.setAttribute("uv",new ia(n,2,3,!1))}this.geometry=Gr,this.material=e,this.center=new Je(.5,.5),this.count=1}intersectsFrustum(e){return e.intersectsSprite(this)}raycast(e,t){e.camera===null&&rt('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Hr.setFromMatrixScale(this.matrixWorld),Yp.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),Wr.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Hr.multiplyScalar(-Wr.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;ol(sl.set(-.5,-.5,0),Wr,o,Hr,s,r),ol(Go.set(.5,-.5,0),Wr,o,Hr,s,r),ol(rl.set(.5,.5,0),Wr,o,Hr,s,r),Hd.set(0,0),pu.set(1,0),Wd.set(1,1);let a=e.ray.intersectTriangle(sl,Go,rl,!1,zo);if(a===null&&(ol(Go.set(-.5,.5,0),Wr,o,Hr,s,r),pu.set(0,1),a=e.ray.intersectTriangle(sl,rl,Go,!1,zo),a===null))return;let l=e.ray.origin.distanceTo(zo);l<e.near||l>e.far||t.push({distance:l,point:zo.clone(),uv:Zi.getInterpolation(zo,sl,Go,rl,Hd,pu,Wd,new Je),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}toJSON(e){let t=super.toJSON(e);return t.object.center=this.center.toArray(),t}};function ol(i,e,t,n,s,r){Xr.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(Vo.x=r*Xr.x-s*Xr.y,Vo.y=s*Xr.x+r*Xr.y):Vo.copy(Xr),i.copy(e),i.x+=Vo.x,i.y+=Vo.y,i.applyMatrix4(Yp)}var ds=new G,mu=new G,al=new G,ll=new G,ks=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ds)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ds.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ds.copy(this.origin).addScaledVector(this.direction,t),ds.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){mu.copy(e).add(t).multiplyScalar(.5),al.copy(t).sub(e).normalize(),ll.copy(this.origin).sub(mu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(al),a=ll.dot(this.direction),l=-ll.dot(al),c=ll.lengthSq(),u=Math.abs(1-o*o),f,h,d,m;if(u>0)if(f=o*l-a,h=o*a-l,m=r*u,f>=0)if(h>=-m)if(h<=m){let _=1/u;f*=_,h*=_,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-m?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=m?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(mu).addScaledVector(al,h),d}intersectSphere(e,t){if(e.radius<0)return null;ds.subVectors(e.center,this.origin);let n=ds.dot(this.direction),s=ds.dot(ds)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(n=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(n=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ds)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,m=t.x-o.x,_=t.y-o.y,g=t.z-o.z,p=n.x-o.x,y=n.y-o.y,R=n.z-o.z,S=Math.abs(l),b=Math.abs(c),M=Math.abs(u),x,w,F,I,T,D,L,P,B,H,z,oe;if(S>=b&&S>=M?(F=l,D=f,B=m,oe=p,l>=0?(x=c,w=u,I=h,T=d,L=_,P=g,H=y,z=R):(x=u,w=c,I=d,T=h,L=g,P=_,H=R,z=y)):b>=M?(F=c,D=h,B=_,oe=y,c>=0?(x=u,w=l,I=d,T=f,L=g,P=m,H=R,z=p):(x=l,w=u,I=f,T=d,L=m,P=g,H=p,z=R)):(F=u,D=d,B=g,oe=R,u>=0?(x=l,w=c,I=f,T=h,L=m,P=_,H=p,z=y):(x=c,w=l,I=h,T=f,L=_,P=m,H=y,z=p)),F===0)return null;let Y=x/F,ee=w/F,ie=1/F,j=I-Y*D,ne=T-ee*D,q=L-Y*B,ue=P-ee*B,le=H-Y*oe,pe=z-ee*oe,de=le*ue-pe*q,Ue=j*pe-ne*le,Ve=q*ne-ue*j;if(s){if(de<0||Ue<0||Ve<0)return null}else if((de<0||Ue<0||Ve<0)&&(de>0||Ue>0||Ve>0))return null;let De=de+Ue+Ve;if(De===0)return null;let Qe=ie*(de*D+Ue*B+Ve*oe);return(De>0?Qe<0:Qe>0)?null:this.at(Qe/De,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},zs=class extends Ki{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new gs,this.combine=oc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Xd=new Et,sr=new ks,cl=new Li,qd=new G,hl=new G,ul=new G,fl=new G,gu=new G,dl=new G,Yd=new G,pl=new G,wt=class extends Un{constructor(e=new gn,t=new zs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){dl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(gu.fromBufferAttribute(f,e),o?dl.addScaledVector(gu,u):dl.addScaledVector(gu.sub(t),u))}t.add(dl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),cl.copy(n.boundingSphere),cl.applyMatrix4(r),sr.copy(e.ray).recast(e.near),!(cl.containsPoint(sr.origin)===!1&&(sr.intersectSphere(cl,qd)===null||sr.origin.distanceToSquared(qd)>(e.far-e.near)**2))&&(Xd.copy(r).invert(),sr.copy(e.ray).applyMatrix4(Xd),!(n.boundingBox!==null&&sr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,sr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=h.length;m<_;m++){let g=h[m],p=o[g.materialIndex],y=Math.max(g.start,d.start),R=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let S=y,b=R;S<b;S+=3){let M=a.getX(S),x=a.getX(S+1),w=a.getX(S+2);s=ml(this,p,e,n,c,u,f,M,x,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let g=m,p=_;g<p;g+=3){let y=a.getX(g),R=a.getX(g+1),S=a.getX(g+2);s=ml(this,o,e,n,c,u,f,y,R,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=h.length;m<_;m++){let g=h[m],p=o[g.materialIndex],y=Math.max(g.start,d.start),R=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let S=y,b=R;S<b;S+=3){let M=S,x=S+1,w=S+2;s=ml(this,p,e,n,c,u,f,M,x,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,d.start),_=Math.min(l.count,d.start+d.count);for(let g=m,p=_;g<p;g+=3){let y=g,R=g+1,S=g+2;s=ml(this,o,e,n,c,u,f,y,R,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function X_(i,e,t,n,s,r,o,a){let l;if(e.side===On?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===Ys,a),l===null)return null;pl.copy(a),pl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(pl);return c<t.near||c>t.far?null:{distance:c,point:pl.clone(),object:i}}function ml(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,hl),i.getVertexPosition(l,ul),i.getVertexPosition(c,fl);let u=X_(i,e,t,n,hl,ul,fl,Yd);if(u){let f=new G;Zi.getBarycoord(Yd,hl,ul,fl,f),s&&(u.uv=Zi.getInterpolatedAttribute(s,a,l,c,f,new Je)),r&&(u.uv1=Zi.getInterpolatedAttribute(r,a,l,c,f,new Je)),o&&(u.normal=Zi.getInterpolatedAttribute(o,a,l,c,f,new G),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new G,materialIndex:0};Zi.getNormal(hl,ul,fl,h.normal),u.face=h,u.barycoord=f}return u}var or=class extends Jn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=In,u=In,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ra=class extends Pn{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},qr=new Et,$d=new Et,gl=[],Zd=new gi,q_=new Et,Ho=new wt,Wo=new Li,oa=class extends wt{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new ra(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,q_)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new gi),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,qr),Zd.copy(e.boundingBox).applyMatrix4(qr),this.boundingBox.union(Zd)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Li),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,qr),Wo.copy(e.boundingSphere).applyMatrix4(qr),this.boundingSphere.union(Wo)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Ho.geometry=this.geometry,Ho.material=this.material,Ho.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Wo.copy(this.boundingSphere),Wo.applyMatrix4(n),e.ray.intersectsSphere(Wo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,qr),$d.multiplyMatrices(n,qr),Ho.matrixWorld=$d,Ho.raycast(e,gl);for(let o=0,a=gl.length;o<a;o++){let l=gl[o];l.instanceId=r,l.object=this,t.push(l)}gl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new ra(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new or(new Float32Array(s*this.count),s,this.count,dc,vi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},rr=new Li,Y_=new Je(.5,.5),_l=new G,Vs=class{constructor(e=new Dn,t=new Dn,n=new Dn,s=new Dn,r=new Dn,o=new Dn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=mi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],m=r[8],_=r[9],g=r[10],p=r[11],y=r[12],R=r[13],S=r[14],b=r[15];if(s[0].setComponents(c-o,d-u,p-m,b-y).normalize(),s[1].setComponents(c+o,d+u,p+m,b+y).normalize(),s[2].setComponents(c+a,d+f,p+_,b+R).normalize(),s[3].setComponents(c-a,d-f,p-_,b-R).normalize(),n)s[4].setComponents(l,h,g,S).normalize(),s[5].setComponents(c-l,d-h,p-g,b-S).normalize();else if(s[4].setComponents(c-l,d-h,p-g,b-S).normalize(),t===mi)s[5].setComponents(c+l,d+h,p+g,b+S).normalize();else if(t===Qr)s[5].setComponents(l,h,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(e){rr.center.set(0,0,0);let t=Y_.distanceTo(e.center);return rr.radius=.7071067811865476+t,rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(_l.x=s.normal.x>0?e.max.x:e.min.x,_l.y=s.normal.y>0?e.max.y:e.min.y,_l.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(_l)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Jd=new Et,Gl=class i{constructor(){this.coordinateSystem=mi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Jd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Vs),n[s].setFromProjectionMatrix(Jd,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Vs),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var _i=class extends Ki{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ct(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Hl=new G,Wl=new G,Kd=new Et,Xo=new ks,xl=new Li,_u=new G,jd=new G,oo=class extends Un{constructor(e=new gn,t=new _i){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Hl.fromBufferAttribute(t,s-1),Wl.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Hl.distanceTo(Wl);e.setAttribute("lineDistance",new kt(n,1))}else nt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),xl.copy(n.boundingSphere),xl.applyMatrix4(s),xl.radius+=r,e.ray.intersectsSphere(xl)===!1)return;Kd.copy(s).invert(),Xo.copy(e.ray).applyMatrix4(Kd);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,h=n.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let _=d,g=m-1;_<g;_+=c){let p=u.getX(_),y=u.getX(_+1),R=yl(this,e,Xo,l,p,y,_);R&&t.push(R)}if(this.isLineLoop){let _=u.getX(m-1),g=u.getX(d),p=yl(this,e,Xo,l,_,g,m-1);p&&t.push(p)}}else{let d=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let _=d,g=m-1;_<g;_+=c){let p=yl(this,e,Xo,l,_,_+1,_);p&&t.push(p)}if(this.isLineLoop){let _=yl(this,e,Xo,l,m-1,d,m-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function yl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Hl.fromBufferAttribute(a,s),Wl.fromBufferAttribute(a,r),t.distanceSqToSegment(Hl,Wl,_u,jd)>n)return;_u.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(_u);if(!(c<e.near||c>e.far))return{distance:c,point:jd.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Qd=new G,ep=new G,_s=class extends oo{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Qd.fromBufferAttribute(t,s),ep.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Qd.distanceTo(ep);e.setAttribute("lineDistance",new kt(n,1))}else nt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var aa=class extends Jn{constructor(e=[],t=ur,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},la=class extends Jn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var xs=class extends Jn{constructor(e,t,n=Di,s,r,o,a=In,l=In,c,u=ms,f=1){if(u!==ms&&u!==Ss)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new no(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ca=class extends xs{constructor(e,t=Di,n=ur,s,r,o=In,a=In,l,c=ms){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ha=class extends Jn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},jn=class i extends gn{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;m("z","y","x",-1,-1,n,t,e,o,r,0),m("z","y","x",1,-1,n,t,-e,o,r,1),m("x","z","y",1,1,e,n,t,s,o,2),m("x","z","y",1,-1,e,n,-t,s,o,3),m("x","y","z",1,-1,e,t,n,s,r,4),m("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new kt(c,3)),this.setAttribute("normal",new kt(u,3)),this.setAttribute("uv",new kt(f,2));function m(_,g,p,y,R,S,b,M,x,w,F){let I=S/x,T=b/w,D=S/2,L=b/2,P=M/2,B=x+1,H=w+1,z=0,oe=0,Y=new G;for(let ee=0;ee<H;ee++){let ie=ee*T-L;for(let j=0;j<B;j++){let ne=j*I-D;Y[_]=ne*y,Y[g]=ie*R,Y[p]=P,c.push(Y.x,Y.y,Y.z),Y[_]=0,Y[g]=0,Y[p]=M>0?1:-1,u.push(Y.x,Y.y,Y.z),f.push(j/x),f.push(1-ee/w),z+=1}}for(let ee=0;ee<w;ee++)for(let ie=0;ie<x;ie++){let j=h+ie+B*ee,ne=h+ie+B*(ee+1),q=h+(ie+1)+B*(ee+1),ue=h+(ie+1)+B*ee;l.push(j,ne,ue),l.push(ne,q,ue),oe+=6}a.addGroup(d,oe,F),d+=oe,h+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var xi=class i extends gn{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],f=[],h=[],d=[],m=0,_=[],g=n/2,p=0;y(),o===!1&&(e>0&&R(!0),t>0&&R(!1)),this.setIndex(u),this.setAttribute("position",new kt(f,3)),this.setAttribute("normal",new kt(h,3)),this.setAttribute("uv",new kt(d,2));function y(){let S=new G,b=new G,M=0,x=(t-e)/n;for(let w=0;w<=r;w++){let F=[],I=w/r,T=I*(t-e)+e;for(let D=0;D<=s;D++){let L=D/s,P=L*l+a,B=Math.sin(P),H=Math.cos(P);b.x=T*B,b.y=-I*n+g,b.z=T*H,f.push(b.x,b.y,b.z),S.set(B,x,H).normalize(),h.push(S.x,S.y,S.z),d.push(L,1-I),F.push(m++)}_.push(F)}for(let w=0;w<s;w++)for(let F=0;F<r;F++){let I=_[F][w],T=_[F+1][w],D=_[F+1][w+1],L=_[F][w+1];(e>0||F!==0)&&(u.push(I,T,L),M+=3),(t>0||F!==r-1)&&(u.push(T,D,L),M+=3)}c.addGroup(p,M,0),p+=M}function R(S){let b=m,M=new Je,x=new G,w=0,F=S===!0?e:t,I=S===!0?1:-1;for(let D=1;D<=s;D++)f.push(0,g*I,0),h.push(0,I,0),d.push(.5,.5),m++;let T=m;for(let D=0;D<=s;D++){let P=D/s*l+a,B=Math.cos(P),H=Math.sin(P);x.x=F*H,x.y=g*I,x.z=F*B,f.push(x.x,x.y,x.z),h.push(0,I,0),M.x=B*.5+.5,M.y=H*.5*I+.5,d.push(M.x,M.y),m++}for(let D=0;D<s;D++){let L=b+D,P=T+D;S===!0?u.push(P,P+1,L):u.push(P+1,P,L),w+=3}c.addGroup(p,w,S===!0?1:2),p+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},ua=class i extends xi{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var vl=new G,Sl=new G,xu=new G,Ml=new Zi,ar=class extends gn{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Jr*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],f=new Array(3),h=new Map,d=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:_,b:g,c:p}=Ml;if(_.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),Ml.getNormal(xu),f[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,f[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,f[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let y=0;y<3;y++){let R=(y+1)%3,S=f[y],b=f[R],M=Ml[u[y]],x=Ml[u[R]],w=`${S}_${b}`,F=`${b}_${S}`,I=h.get(F);I?(xu.dot(I.normal)<=r&&(d.push(M.x,M.y,M.z),d.push(x.x,x.y,x.z)),h.set(F,null)):h.has(w)||h.set(w,{index0:c[y],index1:c[R],normal:xu.clone()})}}for(let m of h.values())if(m){let{index0:_,index1:g}=m;vl.fromBufferAttribute(a,_),Sl.fromBufferAttribute(a,g),d.push(vl.x,vl.y,vl.z),d.push(Sl.x,Sl.y,Sl.z)}this.setAttribute("position",new kt(d,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var fa=class i extends gn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],m=[],_=[],g=[];for(let p=0;p<u;p++){let y=p*h-o;for(let R=0;R<c;R++){let S=R*f-r;m.push(S,-y,0),_.push(0,0,1),g.push(R/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){let R=y+c*p,S=y+c*(p+1),b=y+1+c*(p+1),M=y+1+c*p;d.push(R,S,M),d.push(S,b,M)}this.setIndex(d),this.setAttribute("position",new kt(m,3)),this.setAttribute("normal",new kt(_,3)),this.setAttribute("uv",new kt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var lr=class i extends gn{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],f=new G,h=new G,d=[],m=[],_=[],g=[];for(let p=0;p<=n;p++){let y=[],R=p/n,S=o+R*a,b=e*Math.cos(S),M=Math.sqrt(e*e-b*b),x=0;p===0&&o===0?x=.5/t:p===n&&l===Math.PI&&(x=-.5/t);for(let w=0;w<=t;w++){let F=w/t,I=s+F*r;f.x=-M*Math.cos(I),f.y=b,f.z=M*Math.sin(I),m.push(f.x,f.y,f.z),h.copy(f).normalize(),_.push(h.x,h.y,h.z),g.push(F+x,1-R),y.push(c++)}u.push(y)}for(let p=0;p<n;p++)for(let y=0;y<t;y++){let R=u[p][y+1],S=u[p][y],b=u[p+1][y],M=u[p+1][y+1];(p!==0||o>0)&&d.push(R,S,M),(p!==n-1||l<Math.PI)&&d.push(S,b,M)}this.setIndex(d),this.setAttribute("position",new kt(m,3)),this.setAttribute("normal",new kt(_,3)),this.setAttribute("uv",new kt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function dr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(tp(s))s.isRenderTargetTexture?(nt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(tp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Gn(i){let e={};for(let t=0;t<i.length;t++){let n=dr(i[t]);for(let s in n)e[s]=n[s]}return e}function tp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function $_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function rf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Mt.workingColorSpace}var $p={clone:dr,merge:Gn},Z_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,J_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ji=class extends Ki{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Z_,this.fragmentShader=J_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=dr(e.uniforms),this.uniformsGroups=$_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new ct().setHex(s.value);break;case"v2":this.uniforms[n].value=new Je().fromArray(s.value);break;case"v3":this.uniforms[n].value=new G().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Jt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ht().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Et().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Xl=class extends ji{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Qt=class extends Ki{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ct(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Yc,this.normalScale=new Je(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new gs,this.combine=oc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},ql=class extends Ki{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Np,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Yl=class extends Ki{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Yr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function bl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Gs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},$l=class extends Gs{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Su,endingEnd:Su}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Mu:r=e,a=2*t-n;break;case bu:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Mu:o=e,l=2*n-t;break;case bu:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,m=(n-t)/(s-t),_=m*m,g=_*m,p=-h*g+2*h*_-h*m,y=(1+h)*g+(-1.5-2*h)*_+(-.5+h)*m+1,R=(-1-d)*g+(1.5+d)*_+.5*m,S=d*g-d*_;for(let b=0;b!==a;++b)r[b]=p*o[u+b]+y*o[c+b]+R*o[l+b]+S*o[f+b];return r}},Zl=class extends Gs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},Jl=class extends Gs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Kl=class extends Gs{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let m=(n-t)/(s-t),_=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*_+o[l+g]*m;return r}let h=a*2,d=e-1;for(let m=0;m!==a;++m){let _=o[c+m],g=o[l+m],p=d*h+m*2,y=f[p],R=f[p+1],S=e*h+m*2,b=u[S],M=u[S+1],x=j_(n,t,y,b,s);r[m]=Zp(x,_,R,M,g)}return r}};function Zp(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function K_(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function j_(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=Zp(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=K_(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var li=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Yr(t,this.TimeBufferType),this.values=Yr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Yr(e.times,Array),values:Yr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),bl(e.settings)&&(n.settings={inTangents:Yr(e.settings.inTangents,Array),outTangents:Yr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Jl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Zl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new $l(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Kl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case $o:t=this.InterpolantFactoryMethodDiscrete;break;case Fl:t=this.InterpolantFactoryMethodLinear;break;case Tl:t=this.InterpolantFactoryMethodSmooth;break;case vu:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return nt("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return $o;case this.InterpolantFactoryMethodLinear:return Fl;case this.InterpolantFactoryMethodSmooth:return Tl;case this.InterpolantFactoryMethodBezier:return vu}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;bl(this.settings)&&(np(this.settings.inTangents,e),np(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;bl(this.settings)&&(ip(this.settings.inTangents,e),ip(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(rt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(rt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){rt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){rt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&d_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){rt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Tl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*n,h=f-n,d=f+n;for(let m=0;m!==n;++m){let _=t[f+m];if(_!==t[h+m]||_!==t[d+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*n,h=o*n;for(let d=0;d!==n;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,bl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function np(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function ip(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}li.prototype.ValueTypeName="";li.prototype.TimeBufferType=Float32Array;li.prototype.ValueBufferType=Float32Array;li.prototype.DefaultInterpolation=Fl;var Hs=class extends li{constructor(e,t,n){super(e,t,n)}};Hs.prototype.ValueTypeName="bool";Hs.prototype.ValueBufferType=Array;Hs.prototype.DefaultInterpolation=$o;Hs.prototype.InterpolantFactoryMethodLinear=void 0;Hs.prototype.InterpolantFactoryMethodSmooth=void 0;var jl=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};jl.prototype.ValueTypeName="color";var Ql=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Ql.prototype.ValueTypeName="number";var ec=class extends Gs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)cn.slerpFlat(r,0,o,c-a,o,c,l);return r}},da=class extends li{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new ec(this.times,this.values,this.getValueSize(),e)}};da.prototype.ValueTypeName="quaternion";da.prototype.InterpolantFactoryMethodSmooth=void 0;var Ws=class extends li{constructor(e,t,n){super(e,t,n)}};Ws.prototype.ValueTypeName="string";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=$o;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var tc=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};tc.prototype.ValueTypeName="vector";var nc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],m=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Jp=new nc,ic=class{constructor(e){this.manager=e!==void 0?e:Jp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};ic.DEFAULT_MATERIAL_NAME="__DEFAULT";var pa=class extends Un{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ct(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var yu=new Et,sp=new G,rp=new G,sc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Je(512,512),this.mapType=Qn,this.map=null,this.mapPass=null,this.matrix=new Et,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Vs,this._frameExtents=new Je(1,1),this._viewportCount=1,this._viewports=[new Jt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;sp.setFromMatrixPosition(e.matrixWorld),t.position.copy(sp),rp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(rp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){yu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(yu,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Qr||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(yu)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},wl=new G,El=new cn,$i=new G,ma=class extends Un{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Et,this.projectionMatrix=new Et,this.projectionMatrixInverse=new Et,this.coordinateSystem=mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(wl,El,$i),$i.x===1&&$i.y===1&&$i.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(wl,El,$i.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(wl,El,$i),$i.x===1&&$i.y===1&&$i.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(wl,El,$i.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Bs=new G,op=new Je,ap=new Je,Zn=class extends ma{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=to*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Jr*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return to*2*Math.atan(Math.tan(Jr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Bs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Bs.x,Bs.y).multiplyScalar(-e/Bs.z),Bs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Bs.x,Bs.y).multiplyScalar(-e/Bs.z)}getViewSize(e,t){return this.getViewBounds(e,op,ap),t.subVectors(ap,op)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Jr*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ga=class extends ma{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},wu=class extends sc{constructor(){super(new ga(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},_a=class extends pa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.target=new Un,this.shadow=new wu}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},xa=class extends pa{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var $r=-90,Zr=1,ao=class extends Un{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zn($r,Zr,e,t);s.layers=this.layers,this.add(s);let r=new Zn($r,Zr,e,t);r.layers=this.layers,this.add(r);let o=new Zn($r,Zr,e,t);o.layers=this.layers,this.add(o);let a=new Zn($r,Zr,e,t);a.layers=this.layers,this.add(a);let l=new Zn($r,Zr,e,t);l.layers=this.layers,this.add(l);let c=new Zn($r,Zr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===mi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Qr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=_,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},rc=class extends Zn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var of="\\[\\]\\.:\\/",Q_=new RegExp("["+of+"]","g"),af="[^"+of+"]",ex="[^"+of.replace("\\.","")+"]",tx=/((?:WC+[\/:])*)/.source.replace("WC",af),nx=/(WCOD+)?/.source.replace("WCOD",ex),ix=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",af),sx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",af),rx=new RegExp("^"+tx+nx+ix+sx+"$"),ox=["material","materials","bones","map"],Eu=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Q_,"")}static parseTrackName(e){let t=rx.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ox.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){nt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){rt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){rt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){rt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){rt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){rt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;rt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=Eu;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var P1=new Float32Array(1);var lp=new Et,ys=class{constructor(e,t,n=0,s=1/0){this.ray=new ks(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new io,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):rt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return lp.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(lp),this}intersectObject(e,t=!0,n=[]){return Tu(e,this,n,t),n.sort(cp),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Tu(e[s],this,n,t);return n.sort(cp),n}};function cp(i,e){return i.distance-e.distance}function Tu(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Tu(r[o],e,t,!0)}}var lo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=yt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(yt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Au=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var ya=class extends _s{constructor(e=10,t=10,n=4473924,s=8947848){n=new ct(n),s=new ct(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let h=0,d=0,m=-a;h<=t;h++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let _=h===r?n:s;_.toArray(c,d),d+=3,_.toArray(c,d),d+=3,_.toArray(c,d),d+=3,_.toArray(c,d),d+=3}let u=new gn;u.setAttribute("position",new kt(l,3)),u.setAttribute("color",new kt(c,3));let f=new _i({vertexColors:!0,toneMapped:!1});super(u,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var va=class extends Ii{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function lf(i,e,t,n){let s=ax(n);switch(t){case qu:return i*e;case dc:return i*e/s.components*s.byteLength;case pc:return i*e/s.components*s.byteLength;case $s:return i*e*2/s.components*s.byteLength;case mc:return i*e*2/s.components*s.byteLength;case Yu:return i*e*3/s.components*s.byteLength;case Ui:return i*e*4/s.components*s.byteLength;case gc:return i*e*4/s.components*s.byteLength;case ba:case wa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ea:case Ta:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case xc:case vc:return Math.max(i,16)*Math.max(e,8)/4;case _c:case yc:return Math.max(i,8)*Math.max(e,8)/2;case Sc:case Mc:case wc:case Ec:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case bc:case Aa:case Tc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ac:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Cc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Rc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Pc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Ic:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Lc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Dc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Nc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Uc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Oc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Fc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Bc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case kc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case zc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Vc:case Gc:case Hc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Wc:case Xc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ca:case qc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function ax(i){switch(i){case Qn:case Gu:return{byteLength:1,components:1};case fo:case Hu:case Ni:return{byteLength:2,components:1};case uc:case fc:return{byteLength:2,components:4};case Di:case hc:case vi:return{byteLength:4,components:1};case Wu:case Xu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?nt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function xm(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function cx(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=i.createBuffer();i.bindBuffer(l,h),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function n(a,l,c){let u=l.array,f=l.updateRanges;if(i.bindBuffer(c,a),f.length===0)i.bufferSubData(c,0,u);else{f.sort((d,m)=>d.start-m.start);let h=0;for(let d=1;d<f.length;d++){let m=f[h],_=f[d];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++h,f[h]=_)}f.length=h+1;for(let d=0,m=f.length;d<m;d++){let _=f[d];i.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var hx=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ux=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,fx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,dx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,px=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,mx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,gx=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,_x=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,xx=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,yx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,vx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Sx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Mx=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,bx=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,wx=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Ex=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Tx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Ax=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Cx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Rx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Px=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Ix=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Lx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Dx=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Nx=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Ux=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ox=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Fx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Bx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,kx="gl_FragColor = linearToOutputTexel( gl_FragColor );",zx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Vx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Gx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Hx=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Wx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Xx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,qx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Yx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,$x=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Zx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Jx=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Kx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,jx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Qx=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ey=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,ty=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,ny=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,iy=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,sy=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,ry=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,oy=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,ay=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,ly=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,cy=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,hy=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,uy=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,fy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,dy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,py=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,my=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,gy=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,_y=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,xy=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,yy=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vy=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Sy=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,My=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,by=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,wy=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ey=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Ty=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ay=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Cy=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Ry=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Py=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Iy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Ly=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Dy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Ny=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Uy=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Oy=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Fy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,By=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,ky=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,zy=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Vy=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Gy=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Hy=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Wy=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Xy=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,qy=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Yy=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,$y=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Zy=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Jy=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Ky=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,jy=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Qy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ev=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,tv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,nv=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,iv=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,sv=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,rv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,ov=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,av=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,lv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,cv=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,hv=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,uv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fv=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,pv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mv=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,gv=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,_v=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,xv=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,yv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,vv=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Sv=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Mv=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,bv=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,wv=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ev=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Tv=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Av=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Cv=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Rv=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Pv=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Iv=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Lv=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Dv=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Nv=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Uv=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ov=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Fv=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Bv=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,kv=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,zv=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Vv=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Gv=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,pt={alphahash_fragment:hx,alphahash_pars_fragment:ux,alphamap_fragment:fx,alphamap_pars_fragment:dx,alphatest_fragment:px,alphatest_pars_fragment:mx,aomap_fragment:gx,aomap_pars_fragment:_x,batching_pars_vertex:xx,batching_vertex:yx,begin_vertex:vx,beginnormal_vertex:Sx,bsdfs:Mx,iridescence_fragment:bx,bumpmap_pars_fragment:wx,clipping_planes_fragment:Ex,clipping_planes_pars_fragment:Tx,clipping_planes_pars_vertex:Ax,clipping_planes_vertex:Cx,color_fragment:Rx,color_pars_fragment:Px,color_pars_vertex:Ix,color_vertex:Lx,common:Dx,defaultnormal_vertex:Nx,displacementmap_pars_vertex:Ux,displacementmap_vertex:Ox,emissivemap_fragment:Fx,emissivemap_pars_fragment:Bx,colorspace_fragment:kx,colorspace_pars_fragment:zx,envmap_fragment:Vx,envmap_common_pars_fragment:Gx,envmap_pars_fragment:Hx,envmap_pars_vertex:Wx,envmap_physical_pars_fragment:ty,envmap_vertex:Xx,fog_vertex:qx,fog_pars_vertex:Yx,fog_fragment:$x,fog_pars_fragment:Zx,gradientmap_pars_fragment:Jx,lightmap_pars_fragment:Kx,lights_lambert_fragment:jx,lights_lambert_pars_fragment:Qx,lights_pars_begin:ey,lights_toon_fragment:ny,lights_toon_pars_fragment:iy,lights_phong_fragment:sy,lights_phong_pars_fragment:ry,lights_physical_fragment:oy,lights_physical_pars_fragment:ay,lights_fragment_begin:ly,lights_fragment_maps:cy,lights_fragment_end:hy,lightprobes_pars_fragment:uy,logdepthbuf_fragment:fy,logdepthbuf_pars_fragment:dy,logdepthbuf_pars_vertex:py,logdepthbuf_vertex:my,map_fragment:gy,map_pars_fragment:_y,map_particle_fragment:xy,map_particle_pars_fragment:yy,metalnessmap_fragment:vy,metalnessmap_pars_fragment:Sy,morphinstance_vertex:My,morphcolor_vertex:by,morphnormal_vertex:wy,morphtarget_pars_vertex:Ey,morphtarget_vertex:Ty,normal_fragment_begin:Ay,normal_fragment_maps:Cy,normal_pars_fragment:Ry,normal_pars_vertex:Py,normal_vertex:Iy,normalmap_pars_fragment:Ly,clearcoat_normal_fragment_begin:Dy,clearcoat_normal_fragment_maps:Ny,clearcoat_pars_fragment:Uy,iridescence_pars_fragment:Oy,opaque_fragment:Fy,packing:By,premultiplied_alpha_fragment:ky,project_vertex:zy,dithering_fragment:Vy,dithering_pars_fragment:Gy,roughnessmap_fragment:Hy,roughnessmap_pars_fragment:Wy,shadowmap_pars_fragment:Xy,shadowmap_pars_vertex:qy,shadowmap_vertex:Yy,shadowmask_pars_fragment:$y,skinbase_vertex:Zy,skinning_pars_vertex:Jy,skinning_vertex:Ky,skinnormal_vertex:jy,specularmap_fragment:Qy,specularmap_pars_fragment:ev,tonemapping_fragment:tv,tonemapping_pars_fragment:nv,transmission_fragment:iv,transmission_pars_fragment:sv,uv_pars_fragment:rv,uv_pars_vertex:ov,uv_vertex:av,worldpos_vertex:lv,background_vert:cv,background_frag:hv,backgroundCube_vert:uv,backgroundCube_frag:fv,cube_vert:dv,cube_frag:pv,depth_vert:mv,depth_frag:gv,distance_vert:_v,distance_frag:xv,equirect_vert:yv,equirect_frag:vv,linedashed_vert:Sv,linedashed_frag:Mv,meshbasic_vert:bv,meshbasic_frag:wv,meshlambert_vert:Ev,meshlambert_frag:Tv,meshmatcap_vert:Av,meshmatcap_frag:Cv,meshnormal_vert:Rv,meshnormal_frag:Pv,meshphong_vert:Iv,meshphong_frag:Lv,meshphysical_vert:Dv,meshphysical_frag:Nv,meshtoon_vert:Uv,meshtoon_frag:Ov,points_vert:Fv,points_frag:Bv,shadow_vert:kv,shadow_frag:zv,sprite_vert:Vv,sprite_frag:Gv},Oe={common:{diffuse:{value:new ct(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ht},alphaMap:{value:null},alphaMapTransform:{value:new ht},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ht}},envmap:{envMap:{value:null},envMapRotation:{value:new ht},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ht}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ht}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ht},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ht},normalScale:{value:new Je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ht},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ht}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ht}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ht}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ct(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ct(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ht},alphaTest:{value:0},uvTransform:{value:new ht}},sprite:{diffuse:{value:new ct(16777215)},opacity:{value:1},center:{value:new Je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ht},alphaMap:{value:null},alphaMapTransform:{value:new ht},alphaTest:{value:0}}},ts={basic:{uniforms:Gn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:Gn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new ct(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:Gn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new ct(0)},specular:{value:new ct(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:Gn([Oe.common,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.roughnessmap,Oe.metalnessmap,Oe.fog,Oe.lights,{emissive:{value:new ct(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:Gn([Oe.common,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.gradientmap,Oe.fog,Oe.lights,{emissive:{value:new ct(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:Gn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:Gn([Oe.points,Oe.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:Gn([Oe.common,Oe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:Gn([Oe.common,Oe.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:Gn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:Gn([Oe.sprite,Oe.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new ht},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ht}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:Gn([Oe.common,Oe.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:Gn([Oe.lights,Oe.fog,{color:{value:new ct(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};ts.physical={uniforms:Gn([ts.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ht},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ht},clearcoatNormalScale:{value:new Je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ht},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ht},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ht},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ht},sheen:{value:0},sheenColor:{value:new ct(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ht},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ht},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ht},transmissionSamplerSize:{value:new Je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ht},attenuationDistance:{value:0},attenuationColor:{value:new ct(0)},specularColor:{value:new ct(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ht},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ht},anisotropyVector:{value:new Je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ht}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var Zc={r:0,b:0,g:0},Hv=new Et,ym=new ht;ym.set(-1,0,0,0,1,0,0,0,1);function Wv(i,e,t,n,s,r){let o=new ct(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(y){let R=y.isScene===!0?y.background:null;if(R&&R.isTexture){let S=y.backgroundBlurriness>0;R=e.get(R,S)}return R}function m(y){let R=!1,S=d(y);S===null?g(o,a):S&&S.isColor&&(g(S,1),R=!0);let b=i.xr.getEnvironmentBlendMode();b==="additive"?t.buffers.color.setClear(0,0,0,1,r):b==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||R)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(y,R){let S=d(R);S&&S.isCubeTexture?(c===void 0&&(c=new wt(new jn(1,1,1),new ji({name:"BackgroundCubeMaterial",uniforms:dr(ts.backgroundCube.uniforms),vertexShader:ts.backgroundCube.vertexShader,fragmentShader:ts.backgroundCube.fragmentShader,side:On,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(b,M,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=R.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Hv.makeRotationFromEuler(R.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(ym),c.material.toneMapped=Mt.getTransfer(S.colorSpace)!==It,(u!==S||f!==S.version||h!==i.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new wt(new fa(2,2),new ji({name:"BackgroundMaterial",uniforms:dr(ts.background.uniforms),vertexShader:ts.background.vertexShader,fragmentShader:ts.background.fragmentShader,side:Ys,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,l.material.toneMapped=Mt.getTransfer(S.colorSpace)!==It,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==i.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,R){y.getRGB(Zc,rf(i)),t.buffers.color.setClear(Zc.r,Zc.g,Zc.b,R,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,R=1){o.set(y),a=R,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:m,addToRenderList:_,dispose:p}}function Xv(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=h(null),r=s,o=!1;function a(T,D,L,P,B){let H=!1,z=f(T,P,L,D);r!==z&&(r=z,c(r.object)),H=d(T,P,L,B),H&&m(T,P,L,B),B!==null&&e.update(B,i.ELEMENT_ARRAY_BUFFER),(H||o)&&(o=!1,S(T,D,L,P),B!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(B).buffer))}function l(){return i.createVertexArray()}function c(T){return i.bindVertexArray(T)}function u(T){return i.deleteVertexArray(T)}function f(T,D,L,P){let B=P.wireframe===!0,H=n[D.id];H===void 0&&(H={},n[D.id]=H);let z=T.isInstancedMesh===!0?T.id:0,oe=H[z];oe===void 0&&(oe={},H[z]=oe);let Y=oe[L.id];Y===void 0&&(Y={},oe[L.id]=Y);let ee=Y[B];return ee===void 0&&(ee=h(l()),Y[B]=ee),ee}function h(T){let D=[],L=[],P=[];for(let B=0;B<t;B++)D[B]=0,L[B]=0,P[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:L,attributeDivisors:P,object:T,attributes:{},index:null}}function d(T,D,L,P){let B=r.attributes,H=D.attributes,z=0,oe=L.getAttributes();for(let Y in oe)if(oe[Y].location>=0){let ie=B[Y],j=H[Y];if(j===void 0&&(Y==="instanceMatrix"&&T.instanceMatrix&&(j=T.instanceMatrix),Y==="instanceColor"&&T.instanceColor&&(j=T.instanceColor)),ie===void 0||ie.attribute!==j||j&&ie.data!==j.data)return!0;z++}return r.attributesNum!==z||r.index!==P}function m(T,D,L,P){let B={},H=D.attributes,z=0,oe=L.getAttributes();for(let Y in oe)if(oe[Y].location>=0){let ie=H[Y];ie===void 0&&(Y==="instanceMatrix"&&T.instanceMatrix&&(ie=T.instanceMatrix),Y==="instanceColor"&&T.instanceColor&&(ie=T.instanceColor));let j={};j.attribute=ie,ie&&ie.data&&(j.data=ie.data),B[Y]=j,z++}r.attributes=B,r.attributesNum=z,r.index=P}function _(){let T=r.newAttributes;for(let D=0,L=T.length;D<L;D++)T[D]=0}function g(T){p(T,0)}function p(T,D){let L=r.newAttributes,P=r.enabledAttributes,B=r.attributeDivisors;L[T]=1,P[T]===0&&(i.enableVertexAttribArray(T),P[T]=1),B[T]!==D&&(i.vertexAttribDivisor(T,D),B[T]=D)}function y(){let T=r.newAttributes,D=r.enabledAttributes;for(let L=0,P=D.length;L<P;L++)D[L]!==T[L]&&(i.disableVertexAttribArray(L),D[L]=0)}function R(T,D,L,P,B,H,z){z===!0?i.vertexAttribIPointer(T,D,L,B,H):i.vertexAttribPointer(T,D,L,P,B,H)}function S(T,D,L,P){_();let B=P.attributes,H=L.getAttributes(),z=D.defaultAttributeValues;for(let oe in H){let Y=H[oe];if(Y.location>=0){let ee=B[oe];if(ee===void 0&&(oe==="instanceMatrix"&&T.instanceMatrix&&(ee=T.instanceMatrix),oe==="instanceColor"&&T.instanceColor&&(ee=T.instanceColor)),ee!==void 0){let ie=ee.normalized,j=ee.itemSize,ne=e.get(ee);if(ne===void 0)continue;let q=ne.buffer,ue=ne.type,le=ne.bytesPerElement,pe=ue===i.INT||ue===i.UNSIGNED_INT||ee.gpuType===hc;if(ee.isInterleavedBufferAttribute){let de=ee.data,Ue=de.isInterleavedBuffer===!0?de.stride:de.itemSize,Ve=ee.offset;if(de.isInstancedInterleavedBuffer||de.isInstancedBufferAttribute){for(let De=0;De<Y.locationSize;De++)p(Y.location+De,de.meshPerAttribute);T.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=de.meshPerAttribute*de.count)}else for(let De=0;De<Y.locationSize;De++)g(Y.location+De);i.bindBuffer(i.ARRAY_BUFFER,q);for(let De=0;De<Y.locationSize;De++)R(Y.location+De,j/Y.locationSize,ue,ie,Ue*le,(Ve+j/Y.locationSize*De)*le,pe)}else{if(ee.isInstancedBufferAttribute){for(let de=0;de<Y.locationSize;de++)p(Y.location+de,ee.meshPerAttribute);T.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let de=0;de<Y.locationSize;de++)g(Y.location+de);i.bindBuffer(i.ARRAY_BUFFER,q);for(let de=0;de<Y.locationSize;de++)R(Y.location+de,j/Y.locationSize,ue,ie,j*le,j/Y.locationSize*de*le,pe)}}else if(z!==void 0){let ie=z[oe];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(Y.location,ie);break;case 3:i.vertexAttrib3fv(Y.location,ie);break;case 4:i.vertexAttrib4fv(Y.location,ie);break;default:i.vertexAttrib1fv(Y.location,ie)}}}}y()}function b(){F();for(let T in n){let D=n[T];for(let L in D){let P=D[L];for(let B in P){let H=P[B];for(let z in H)u(H[z].object),delete H[z];delete P[B]}}delete n[T]}}function M(T){if(n[T.id]===void 0)return;let D=n[T.id];for(let L in D){let P=D[L];for(let B in P){let H=P[B];for(let z in H)u(H[z].object),delete H[z];delete P[B]}}delete n[T.id]}function x(T){for(let D in n){let L=n[D];for(let P in L){let B=L[P];if(B[T.id]===void 0)continue;let H=B[T.id];for(let z in H)u(H[z].object),delete H[z];delete B[T.id]}}}function w(T){for(let D in n){let L=n[D],P=T.isInstancedMesh===!0?T.id:0,B=L[P];if(B!==void 0){for(let H in B){let z=B[H];for(let oe in z)u(z[oe].object),delete z[oe];delete B[H]}delete L[P],Object.keys(L).length===0&&delete n[D]}}}function F(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:I,dispose:b,releaseStatesOfGeometry:M,releaseStatesOfObject:w,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:g,disableUnusedAttributes:y}}function qv(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Yv(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Ui&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let w=x===Ni&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==Qn&&x!==vi&&!w&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(nt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&nt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&nt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),R=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),b=i.getParameter(i.MAX_SAMPLES),M=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:y,maxVaryings:R,maxFragmentUniforms:S,maxSamples:b,samples:M}}function $v(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Dn,a=new ht,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||n!==0||s;return s=h,n=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let m=f.clippingPlanes,_=f.clipIntersection,g=f.clipShadows,p=i.get(f);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let y=r?0:n,R=y*4,S=p.clippingState||null;l.value=S,S=u(m,h,R,d);for(let b=0;b!==R;++b)S[b]=t[b];p.clippingState=S,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(f,h,d,m){let _=f!==null?f.length:0,g=null;if(_!==0){if(g=l.value,m!==!0||g===null){let p=d+_*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<p)&&(g=new Float32Array(p));for(let R=0,S=d;R!==_;++R,S+=4)o.copy(f[R]).applyMatrix4(y,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,g}}var Ia=class extends ai{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new aa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new jn(5,5,5),r=new ji({name:"CubemapFromEquirect",uniforms:dr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:On,blending:cr});r.uniforms.tEquirect.value=t;let o=new wt(s,r),a=t.minFilter;return t.minFilter===vs&&(t.minFilter=Nn),new ao(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Kp=256,Zv=3,Jv=20,vm=256,Sm=16,Kv=3,jv=new G,Qv=new ct,Kc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ao(1,10,null),this._boxMesh=new wt(new jn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=jv}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(Qv));let g=new ao(n,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=m,e.background=_,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=em(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Qp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Kp,ef(e))}_fromTexture(e,t){e.mapping===ur||e.mapping===uo?this._setSize(e.image.length===0?Kp:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=jp(e,!1,!1),n=Math.log2(e)-Zv;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=jp(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===ur||e.mapping===uo?(this._cubemapMaterial===null&&(this._cubemapMaterial=em()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Qp()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=eS(),this._integrationMaterial=tS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Sm);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Kv)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(vm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=nS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function jp(i,e,t){return new Ia(i,{minFilter:vs,generateMipmaps:e,type:Ni,colorSpace:Zo,depthBuffer:t})}function La(i,e,t){return new ji({name:i,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:On,blending:cr,depthTest:!1,depthWrite:!1})}function eS(){return La("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${vm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function tS(){return La("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Sm}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function nS(){return La("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Jv}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Qp(){return La("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function em(){return La("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function iS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===ac||d===lc)if(e.has(h)){let m=e.get(h).texture;return a(m,h.mapping)}else{let m=h.image;if(m&&m.height>0){let _=new Ia(m.height);return _.fromEquirectangularTexture(i,h),e.set(h,_),h.addEventListener("dispose",c),a(_.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,m=d===ac||d===lc,_=d===ur||d===uo;if(m||_){let g=t.get(h),p=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==p)return n===null&&(n=new Kc(i)),g=m?n.fromEquirectangular(h,g):n.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let y=h.image;return m&&y&&y.height>0||_&&y&&l(y)?(n===null&&(n=new Kc(i)),g=m?n.fromEquirectangular(h):n.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,d){return d===ac?h.mapping=ur:d===lc&&(h.mapping=uo),h}function l(h){let d=0,m=6;for(let _=0;_<m;_++)h[_]!==void 0&&d++;return d===m}function c(h){let d=h.target;d.removeEventListener("dispose",c);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function f(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function sS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&qo("WebGLRenderer: "+n+" extension not supported."),s}}}function rS(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let g in m.attributes)e.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let _=r.get(m);_&&(e.remove(_),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function u(m){let _=m.attributes;for(let g in _)e.update(_[g],i.ARRAY_BUFFER)}function f(m){let _=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let y=_!==null?_.array.length:g.array.length/3-1,R=g.count>=65535?na:ta,S=new R(Math.ceil(y/3)*6,1),b=S.array;if(_!==null){let x=_.array;p=_.version;for(let w=0,F=0;w<y;w+=3){let I=x[w+0],T=x[w+1],D=x[w+2];b[F++]=I,b[F++]=T,b[F++]=T,b[F++]=D,b[F++]=D,b[F++]=I}}else{p=g.version;for(let x=0,w=0;x<y;x+=3){let F=x+0,I=x+1,T=x+2;b[w++]=F,b[w++]=I,b[w++]=I,b[w++]=T,b[w++]=T,b[w++]=F}}S.version=p;let M=r.get(m);M&&e.remove(M),r.set(m,S)}function h(m){let _=r.get(m);if(_){let g=m.index;g!==null&&_.version<g.version&&f(m)}else f(m);return r.get(m)}function d(){for(let m in s){let _=s[m].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function oS(i,e,t){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){i.drawElements(n,h,r,f*o),t.update(h,n,1)}function c(f,h,d){d!==0&&(i.drawElementsInstanced(n,h,r,f*o,d),t.update(h,n,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,h,0,r,f,0,d);let _=0;for(let g=0;g<d;g++)_+=h[g];t.update(_,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function aS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:rt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function lS(i,e,t){let n=new WeakMap,s=new Jt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=n.get(a);if(h===void 0||h.count!==f){let F=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",F)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],R=0;d===!0&&(R=1),m===!0&&(R=2),_===!0&&(R=3);let S=a.attributes.position.count*R,b=1;S>e.maxTextureSize&&(b=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let M=new Float32Array(S*b*4*f),x=new Qo(M,S,b,f);x.type=vi,x.needsUpdate=!0;let w=R*4;for(let I=0;I<f;I++){let T=g[I],D=p[I],L=y[I],P=S*b*4*I;for(let B=0;B<T.count;B++){let H=B*w;d===!0&&(s.fromBufferAttribute(T,B),M[P+H+0]=s.x,M[P+H+1]=s.y,M[P+H+2]=s.z,M[P+H+3]=0),m===!0&&(s.fromBufferAttribute(D,B),M[P+H+4]=s.x,M[P+H+5]=s.y,M[P+H+6]=s.z,M[P+H+7]=0),_===!0&&(s.fromBufferAttribute(L,B),M[P+H+8]=s.x,M[P+H+9]=s.y,M[P+H+10]=s.z,M[P+H+11]=L.itemSize===4?s.w:1)}}h={count:f,texture:x,size:new Je(S,b)},n.set(a,h),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let d=0;for(let _=0;_<c.length;_++)d+=c[_];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",h.size)}return{update:r}}function cS(i,e,t,n,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var hS={[Nu]:"LINEAR_TONE_MAPPING",[Uu]:"REINHARD_TONE_MAPPING",[Ou]:"CINEON_TONE_MAPPING",[Fu]:"ACES_FILMIC_TONE_MAPPING",[ku]:"AGX_TONE_MAPPING",[zu]:"NEUTRAL_TONE_MAPPING",[Bu]:"CUSTOM_TONE_MAPPING"};function uS(i,e,t,n,s,r){let o=new ai(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new gn;u.setAttribute("position",new kt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new kt([0,2,0,0,2,0],2));let f=new Xl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new wt(u,f),d=new ga(-1,1,1,-1,0,1),m=null,_=null,g=!1,p,y=null,R=[],S=!1;this.setSize=function(b,M){o.setSize(b,M),a!==null&&a.setSize(b,M),l!==null&&l.setSize(b,M);for(let x=0;x<R.length;x++){let w=R[x];w.setSize&&w.setSize(b,M)}},this.setEffects=function(b){R=b,S=R.length>0&&R[0].isRenderPass===!0;let M=o.width,x=o.height;R.length>0&&a===null&&(a=new ai(M,x,{type:Ni,depthBuffer:!1,stencilBuffer:!1}),l=new ai(M,x,{type:Ni,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&R.some(F=>F.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new xs(M,x),r===!0&&(c.format=Ss,c.type=fr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let F=0;F<R.length;F++){let I=R[F];I.setSize&&I.setSize(M,x),w&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(b,M){if(g||b.toneMapping===Qi&&R.length===0)return!1;if(y=M,M!==null){let x=M.width,w=M.height;(o.width!==x||o.height!==w)&&this.setSize(x,w)}return S===!1&&b.setRenderTarget(o),p=b.toneMapping,b.toneMapping=Qi,!0},this.hasRenderPass=function(){return S},this.end=function(b,M){b.toneMapping=p,g=!0;let x=o,w=a;for(let F=0;F<R.length;F++){let I=R[F];I.enabled!==!1&&(I.render(b,w,x,M),I.needsSwap!==!1&&(x=w,w=w===a?l:a))}if(m!==b.outputColorSpace||_!==b.toneMapping){m=b.outputColorSpace,_=b.toneMapping,f.defines={},Mt.getTransfer(m)===It&&(f.defines.SRGB_TRANSFER="");let F=hS[_];F&&(f.defines[F]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,b.setRenderTarget(y),b.render(h,d),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var Mm=new Jn,bm=new xs(1,1),wm=new ca(1),Em=new Qo,Tm=new zl,Am=new aa,tm=[],nm=[],im=new Float32Array(16),sm=new Float32Array(9),rm=new Float32Array(4);function mo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=tm[s];if(r===void 0&&(r=new Float32Array(s),tm[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function yn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function vn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Qc(i,e){let t=nm[e];t===void 0&&(t=new Int32Array(e),nm[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function fS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function dS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;i.uniform2fv(this.addr,e),vn(t,e)}}function pS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(yn(t,e))return;i.uniform3fv(this.addr,e),vn(t,e)}}function mS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;i.uniform4fv(this.addr,e),vn(t,e)}}function gS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(yn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,n))return;rm.set(n),i.uniformMatrix2fv(this.addr,!1,rm),vn(t,n)}}function _S(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(yn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,n))return;sm.set(n),i.uniformMatrix3fv(this.addr,!1,sm),vn(t,n)}}function xS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(yn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,n))return;im.set(n),i.uniformMatrix4fv(this.addr,!1,im),vn(t,n)}}function yS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function vS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;i.uniform2iv(this.addr,e),vn(t,e)}}function SS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yn(t,e))return;i.uniform3iv(this.addr,e),vn(t,e)}}function MS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;i.uniform4iv(this.addr,e),vn(t,e)}}function bS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function wS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;i.uniform2uiv(this.addr,e),vn(t,e)}}function ES(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yn(t,e))return;i.uniform3uiv(this.addr,e),vn(t,e)}}function TS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;i.uniform4uiv(this.addr,e),vn(t,e)}}function eh(i){return i.version===0&&(i.compareFunction=Ju,i.needsUpdate=!0),i}function AS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=eh(bm):r=Mm,t.setTexture2D(e||r,s)}function CS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Tm,s)}function RS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=eh(wm):r=Am,t.setTextureCube(e||r,s)}function PS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Em,s)}function IS(i){switch(i){case 5126:return fS;case 35664:return dS;case 35665:return pS;case 35666:return mS;case 35674:return gS;case 35675:return _S;case 35676:return xS;case 5124:case 35670:return yS;case 35667:case 35671:return vS;case 35668:case 35672:return SS;case 35669:case 35673:return MS;case 5125:return bS;case 36294:return wS;case 36295:return ES;case 36296:return TS;case 35678:case 36198:case 36298:case 36306:case 35682:return AS;case 35679:case 36299:case 36307:return CS;case 35680:case 36300:case 36308:case 36293:return RS;case 36289:case 36303:case 36311:case 36292:return PS}}function LS(i,e){i.uniform1fv(this.addr,e)}function DS(i,e){let t=mo(e,this.size,2);i.uniform2fv(this.addr,t)}function NS(i,e){let t=mo(e,this.size,3);i.uniform3fv(this.addr,t)}function US(i,e){let t=mo(e,this.size,4);i.uniform4fv(this.addr,t)}function OS(i,e){let t=mo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function FS(i,e){let t=mo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function BS(i,e){let t=mo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function kS(i,e){i.uniform1iv(this.addr,e)}function zS(i,e){i.uniform2iv(this.addr,e)}function VS(i,e){i.uniform3iv(this.addr,e)}function GS(i,e){i.uniform4iv(this.addr,e)}function HS(i,e){i.uniform1uiv(this.addr,e)}function WS(i,e){i.uniform2uiv(this.addr,e)}function XS(i,e){i.uniform3uiv(this.addr,e)}function qS(i,e){i.uniform4uiv(this.addr,e)}function YS(i,e,t){let n=this.cache,s=e.length,r=Qc(t,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=eh(bm):o=Mm;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function $S(i,e,t){let n=this.cache,s=e.length,r=Qc(t,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Tm,r[o])}function ZS(i,e,t){let n=this.cache,s=e.length,r=Qc(t,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=eh(wm):o=Am;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function JS(i,e,t){let n=this.cache,s=e.length,r=Qc(t,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Em,r[o])}function KS(i){switch(i){case 5126:return LS;case 35664:return DS;case 35665:return NS;case 35666:return US;case 35674:return OS;case 35675:return FS;case 35676:return BS;case 5124:case 35670:return kS;case 35667:case 35671:return zS;case 35668:case 35672:return VS;case 35669:case 35673:return GS;case 5125:return HS;case 36294:return WS;case 36295:return XS;case 36296:return qS;case 35678:case 36198:case 36298:case 36306:case 35682:return YS;case 35679:case 36299:case 36307:return $S;case 35680:case 36300:case 36308:case 36293:return ZS;case 36289:case 36303:case 36311:case 36292:return JS}}var uf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=IS(t.type)}},ff=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=KS(t.type)}},df=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},cf=/(\w+)(\])?(\[|\.)?/g;function om(i,e){i.seq.push(e),i.map[e.id]=e}function jS(i,e,t){let n=i.name,s=n.length;for(cf.lastIndex=0;;){let r=cf.exec(n),o=cf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){om(t,c===void 0?new uf(a,i,e):new ff(a,i,e));break}else{let f=t.map[a];f===void 0&&(f=new df(a),om(t,f)),t=f}}}var po=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);jS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function am(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var QS=37297,eM=0;function tM(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var lm=new ht;function nM(i){Mt._getMatrix(lm,Mt.workingColorSpace,i);let e=`mat3( ${lm.elements.map(t=>t.toFixed(4))} )`;switch(Mt.getTransfer(i)){case Jo:return[e,"LinearTransferOETF"];case It:return[e,"sRGBTransferOETF"];default:return nt("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function cm(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+tM(i.getShaderSource(e),a)}else return r}function iM(i,e){let t=nM(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var sM={[Nu]:"Linear",[Uu]:"Reinhard",[Ou]:"Cineon",[Fu]:"ACESFilmic",[ku]:"AgX",[zu]:"Neutral",[Bu]:"Custom"};function rM(i,e){let t=sM[e];return t===void 0?(nt("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Jc=new G;function oM(){Mt.getLuminanceCoefficients(Jc);let i=Jc.x.toFixed(4),e=Jc.y.toFixed(4),t=Jc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function aM(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Pa).join(`
`)}function lM(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function cM(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Pa(i){return i!==""}function hm(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function um(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var hM=/^[ \t]*#include +<([\w\d./]+)>/gm;function pf(i){return i.replace(hM,uM)}function uM(i,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return pf(t)}var fM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function fm(i){return i.replace(fM,dM)}function dM(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function dm(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var pM={[Sa]:"SHADOWMAP_TYPE_PCF",[co]:"SHADOWMAP_TYPE_VSM"};function mM(i){return pM[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var gM={[uo]:"ENVMAP_MODE_REFRACTION"};function _M(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":gM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var xM={[oc]:"ENVMAP_BLENDING_MULTIPLY",[Ip]:"ENVMAP_BLENDING_MIX",[Lp]:"ENVMAP_BLENDING_ADD"};function yM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":xM[i.combine]||"ENVMAP_BLENDING_NONE"}function vM(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=mM(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=_M(t),f=yM(t),h=aM(t),d=lM(r),m=s.createProgram(),_,g,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Pa).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Pa).join(`
`),g.length>0&&(g+=`
`)):(_=[dm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Pa).join(`
`),g=[dm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Qi?"#define TONE_MAPPING":"",t.toneMapping!==Qi?pt.tonemapping_pars_fragment:"",t.toneMapping!==Qi?rM("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,iM("linearToOutputTexel",t.outputColorSpace),oM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Pa).join(`
`)),o=pf(o),o=hm(o,t),o=um(o,t),a=pf(a),a=hm(a,t),a=um(a,t),o=fm(o),a=fm(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,_=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",t.glslVersion===ju?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===ju?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=p+_+o,R=p+g+a,S=am(s,s.VERTEX_SHADER,y),b=am(s,s.FRAGMENT_SHADER,R);s.attachShader(m,S),s.attachShader(m,b),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function M(I){if(i.debug.checkShaderErrors){let T=s.getProgramInfoLog(m)||"",D=s.getShaderInfoLog(S)||"",L=s.getShaderInfoLog(b)||"",P=T.trim(),B=D.trim(),H=L.trim(),z=!0,oe=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,S,b);else{let Y=cm(s,S,"vertex"),ee=cm(s,b,"fragment");rt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+P+`
`+Y+`
`+ee)}else P!==""?nt("WebGLProgram: Program Info Log:",P):(B===""||H==="")&&(oe=!1);oe&&(I.diagnostics={runnable:z,programLog:P,vertexShader:{log:B,prefix:_},fragmentShader:{log:H,prefix:g}})}s.deleteShader(S),s.deleteShader(b),x=new po(s,m),w=cM(s,m)}let x;this.getUniforms=function(){return x===void 0&&M(this),x};let w;this.getAttributes=function(){return w===void 0&&M(this),w};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(m,QS)),F},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=eM++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=b,this}var SM=0,mf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new gf(e),t.set(e,n)),n}},gf=class{constructor(e){this.id=SM++,this.code=e,this.usedTimes=0}};function MM(i){return i===$s||i===Aa||i===Ca}function bM(i,e,t,n,s,r){let o=new io,a=new mf,l=new Set,c=[],u=new Map,f=n.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function m(x,w,F,I,T,D){let L=I.fog,P=T.geometry,B=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,z=e.get(x.envMap||B,H),oe=h[x.type],Y=n.precision;x.precision!==null&&(Y=n.getMaxPrecision(x.precision),Y!==x.precision&&nt("WebGLProgram.getParameters:",x.precision,"not supported, using",Y,"instead."));let ee=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,ie=ee!==void 0?ee.length:0,j=0;P.morphAttributes.position!==void 0&&(j=1),P.morphAttributes.normal!==void 0&&(j=2),P.morphAttributes.color!==void 0&&(j=3);let ne,q,ue,le;if(oe){let Ie=ts[oe];ne=Ie.vertexShader,q=Ie.fragmentShader}else{ne=x.vertexShader,q=x.fragmentShader;let Ie=a.getVertexShaderStage(x),ft=a.getFragmentShaderStage(x);a.update(x,Ie,ft),ue=Ie.id,le=ft.id}let pe=i.getRenderTarget(),de=i.state.buffers.depth.getReversed(),Ue=T.isInstancedMesh===!0,Ve=T.isBatchedMesh===!0,De=!!x.map,Qe=!!x.matcap,tt=!!z,Be=tt&&z.isPMREMTexture===!0,Bt=!!x.aoMap,Dt=!!x.lightMap,en=!!x.bumpMap&&x.wireframe===!1,Z=!!x.normalMap,me=!!x.displacementMap,Se=!!x.emissiveMap,Ke=!!x.metalnessMap,it=!!x.roughnessMap,gt=x.anisotropy>0,k=x.clearcoat>0,Me=x.diffuseRoughness>0,$e=x.dispersion>0,We=x.retroreflectivity>0,ye=x.iridescence>0,mt=x.sheen>0,ke=x.transmission>0,et=gt&&!!x.anisotropyMap,N=k&&!!x.clearcoatMap,E=k&&!!x.clearcoatNormalMap,$=k&&!!x.clearcoatRoughnessMap,_e=Me&&!!x.diffuseRoughnessMap,he=ye&&!!x.iridescenceMap,we=ye&&!!x.iridescenceThicknessMap,Ee=mt&&!!x.sheenColorMap,se=mt&&!!x.sheenRoughnessMap,ae=!!x.specularMap,ve=!!x.specularColorMap,V=!!x.specularIntensityMap,ce=ke&&!!x.transmissionMap,re=ke&&!!x.thicknessMap,Ce=!!x.gradientMap,be=!!x.alphaMap,Ae=x.alphaTest>0,Ze=!!x.alphaHash,ot=!!x.extensions,ge=Qi;x.toneMapped&&(pe===null||pe.isXRRenderTarget===!0)&&(ge=i.toneMapping);let Xe=Be?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,at={shaderID:oe,shaderType:x.type,shaderName:x.name,vertexShader:ne,fragmentShader:q,defines:x.defines,customVertexShaderID:ue,customFragmentShaderID:le,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Y,batching:Ve,batchingColor:Ve&&T._colorsTexture!==null,instancing:Ue,instancingColor:Ue&&T.instanceColor!==null,instancingMorph:Ue&&T.morphTexture!==null,outputColorSpace:pe===null?i.outputColorSpace:pe.isXRRenderTarget===!0?pe.texture.colorSpace:Mt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:De,matcap:Qe,envMap:tt,envMapMode:tt&&z.mapping,envMapPMREM:Be,envMapMaxLod:Be?Xe.length-1:null,envMapSize:Be?Xe[0].width:null,aoMap:Bt,lightMap:Dt,bumpMap:en,normalMap:Z,displacementMap:me,emissiveMap:Se,normalMapObjectSpace:Z&&x.normalMapType===Up,normalMapTangentSpace:Z&&x.normalMapType===Yc,packedNormalMap:Z&&x.normalMapType===Yc&&MM(x.normalMap.format),metalnessMap:Ke,roughnessMap:it,anisotropy:gt,anisotropyMap:et,clearcoat:k,clearcoatMap:N,clearcoatNormalMap:E,clearcoatRoughnessMap:$,diffuseRoughness:Me,diffuseRoughnessMap:_e,dispersion:$e,retroreflection:We,iridescence:ye,iridescenceMap:he,iridescenceThicknessMap:we,sheen:mt,sheenColorMap:Ee,sheenRoughnessMap:se,specularMap:ae,specularColorMap:ve,specularIntensityMap:V,transmission:ke,transmissionMap:ce,thicknessMap:re,gradientMap:Ce,opaque:x.transparent===!1&&x.blending===ho&&x.alphaToCoverage===!1,alphaMap:be,alphaTest:Ae,alphaHash:Ze,combine:x.combine,mapUv:De&&d(x.map.channel),aoMapUv:Bt&&d(x.aoMap.channel),lightMapUv:Dt&&d(x.lightMap.channel),bumpMapUv:en&&d(x.bumpMap.channel),normalMapUv:Z&&d(x.normalMap.channel),displacementMapUv:me&&d(x.displacementMap.channel),emissiveMapUv:Se&&d(x.emissiveMap.channel),metalnessMapUv:Ke&&d(x.metalnessMap.channel),roughnessMapUv:it&&d(x.roughnessMap.channel),anisotropyMapUv:et&&d(x.anisotropyMap.channel),clearcoatMapUv:N&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:_e&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:he&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:we&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:Ee&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:se&&d(x.sheenRoughnessMap.channel),specularMapUv:ae&&d(x.specularMap.channel),specularColorMapUv:ve&&d(x.specularColorMap.channel),specularIntensityMapUv:V&&d(x.specularIntensityMap.channel),transmissionMapUv:ce&&d(x.transmissionMap.channel),thicknessMapUv:re&&d(x.thicknessMap.channel),alphaMapUv:be&&d(x.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Z||gt),vertexNormals:!!P.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:T.isPoints===!0&&!!P.attributes.uv&&(De||be),fog:!!L,useFog:x.fog===!0,fogExp2:!!L&&L.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||P.attributes.normal===void 0&&Z===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:de,skinning:T.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:j,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:D.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&F.length>0,shadowMapType:i.shadowMap.type,toneMapping:ge,decodeVideoTexture:De&&x.map.isVideoTexture===!0&&Mt.getTransfer(x.map.colorSpace)===It,decodeVideoTextureEmissive:Se&&x.emissiveMap.isVideoTexture===!0&&Mt.getTransfer(x.emissiveMap.colorSpace)===It,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===yi,flipSided:x.side===On,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:ot&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ot&&x.extensions.multiDraw===!0||Ve)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return at.vertexUv1s=l.has(1),at.vertexUv2s=l.has(2),at.vertexUv3s=l.has(3),l.clear(),at}function _(x){let w=[];if(x.shaderID?w.push(x.shaderID):(w.push(x.customVertexShaderID),w.push(x.customFragmentShaderID)),x.defines!==void 0)for(let F in x.defines)w.push(F),w.push(x.defines[F]);return x.isRawShaderMaterial===!1&&(g(w,x),p(w,x),w.push(i.outputColorSpace)),w.push(x.customProgramCacheKey),w.join()}function g(x,w){x.push(w.precision),x.push(w.outputColorSpace),x.push(w.envMapMode),x.push(w.envMapPMREM),x.push(w.envMapMaxLod),x.push(w.envMapSize),x.push(w.mapUv),x.push(w.alphaMapUv),x.push(w.lightMapUv),x.push(w.aoMapUv),x.push(w.bumpMapUv),x.push(w.normalMapUv),x.push(w.displacementMapUv),x.push(w.emissiveMapUv),x.push(w.metalnessMapUv),x.push(w.roughnessMapUv),x.push(w.anisotropyMapUv),x.push(w.clearcoatMapUv),x.push(w.clearcoatNormalMapUv),x.push(w.clearcoatRoughnessMapUv),x.push(w.diffuseRoughnessMapUv),x.push(w.iridescenceMapUv),x.push(w.iridescenceThicknessMapUv),x.push(w.sheenColorMapUv),x.push(w.sheenRoughnessMapUv),x.push(w.specularMapUv),x.push(w.specularColorMapUv),x.push(w.specularIntensityMapUv),x.push(w.transmissionMapUv),x.push(w.thicknessMapUv),x.push(w.combine),x.push(w.fogExp2),x.push(w.sizeAttenuation),x.push(w.morphTargetsCount),x.push(w.numSunLights),x.push(w.numDirLights),x.push(w.numPointLights),x.push(w.numSpotLights),x.push(w.numSpotLightMaps),x.push(w.numHemiLights),x.push(w.numRectAreaLights),x.push(w.numSunLightShadows),x.push(w.numDirLightShadows),x.push(w.numPointLightShadows),x.push(w.numSpotLightShadows),x.push(w.numSpotLightShadowsWithMaps),x.push(w.numLightProbes),x.push(w.numLightProbeGrids),x.push(w.shadowMapType),x.push(w.toneMapping),x.push(w.numClippingPlanes),x.push(w.numClipIntersection),x.push(w.depthPacking)}function p(x,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let w=h[x.type],F;if(w){let I=ts[w];F=$p.clone(I.uniforms)}else F=x.uniforms;return F}function R(x,w){let F=u.get(w);return F!==void 0?++F.usedTimes:(F=new vM(i,w,x,s),c.push(F),u.set(w,F)),F}function S(x){if(--x.usedTimes===0){let w=c.indexOf(x);c[w]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function b(x){a.remove(x)}function M(){a.dispose()}return{getParameters:m,getProgramCacheKey:_,getUniforms:y,acquireProgram:R,releaseProgram:S,releaseShaderCache:b,programs:c,dispose:M}}function wM(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function EM(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function pm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function mm(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,m,_,g,p){let y=i[e];return y===void 0?(y={id:h.id,object:h,geometry:d,material:m,materialVariant:o(h),groupOrder:_,renderOrder:h.renderOrder,z:g,group:p},i[e]=y):(y.id=h.id,y.object=h,y.geometry=d,y.material=m,y.materialVariant=o(h),y.groupOrder=_,y.renderOrder=h.renderOrder,y.z=g,y.group=p),e++,y}function l(h,d,m,_,g,p,y){y.reversedDepth===!0&&(g=-g);let R=a(h,d,m,_,g,p);m.transmission>0?n.push(R):m.transparent===!0?s.push(R):t.push(R)}function c(h,d,m,_,g,p){let y=a(h,d,m,_,g,p);m.transmission>0?n.unshift(y):m.transparent===!0?s.unshift(y):t.unshift(y)}function u(h,d){t.length>1&&t.sort(h||EM),n.length>1&&n.sort(d||pm),s.length>1&&s.sort(d||pm)}function f(){for(let h=e,d=i.length;h<d;h++){let m=i[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function TM(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new mm,i.set(n,[o])):s>=r.length?(o=new mm,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function AM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new ct};break;case"SpotLight":t={position:new G,direction:new G,color:new ct,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new ct,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new ct,groundColor:new ct};break;case"RectAreaLight":t={color:new ct,position:new G,halfWidth:new G,halfHeight:new G};break}return i[e.id]=t,t}}}function CM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var RM=0;function PM(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function IM(i){let e=new AM,t=CM(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new G);let s=new G,r=new Et,o=new Et;function a(c){let u=0,f=0,h=0;for(let D=0;D<9;D++)n.probe[D].set(0,0,0);let d=0,m=0,_=0,g=0,p=0,y=0,R=0,S=0,b=0,M=0,x=0,w=0,F=0,I=0;c.sort(PM);for(let D=0,L=c.length;D<L;D++){let P=c[D],B=P.color,H=P.intensity,z=P.distance,oe=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===$s?oe=P.shadow.map.texture:oe=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=B.r*H,f+=B.g*H,h+=B.b*H;else if(P.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(P.sh.coefficients[Y],H);I++}else if(P.isSunLight){let Y=e.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let ee=P.shadow,ie=t.get(P);ie.shadowIntensity=ee.intensity,ie.shadowBias=ee.bias,ie.shadowNormalBias=ee.normalBias,ie.shadowRadius=ee.radius,ie.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),n.sunShadow[m]=ie,n.sunShadowMap[m]=oe;let j=ee.getViewportCount();for(let ne=0;ne<j;ne++)n.sunShadowMatrix[_+ne]=ee.getMatrix(ne),n.sunShadowCascade[_+ne]=ee._cascadeData[ne];_+=j,m++}n.sun[d]=Y,d++}else if(P.isDirectionalLight){let Y=e.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let ee=P.shadow,ie=t.get(P);ie.shadowIntensity=ee.intensity,ie.shadowBias=ee.bias,ie.shadowNormalBias=ee.normalBias,ie.shadowRadius=ee.radius,ie.shadowMapSize=ee.mapSize,n.directionalShadow[g]=ie,n.directionalShadowMap[g]=oe,n.directionalShadowMatrix[g]=P.shadow.matrix,b++}n.directional[g]=Y,g++}else if(P.isSpotLight){let Y=e.get(P);Y.position.setFromMatrixPosition(P.matrixWorld),Y.color.copy(B).multiplyScalar(H),Y.distance=z,Y.coneCos=Math.cos(P.angle),Y.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),Y.decay=P.decay,n.spot[y]=Y;let ee=P.shadow;if(P.map&&(n.spotLightMap[w]=P.map,w++,ee.updateMatrices(P),P.castShadow&&F++),n.spotLightMatrix[y]=ee.matrix,P.castShadow){let ie=t.get(P);ie.shadowIntensity=ee.intensity,ie.shadowBias=ee.bias,ie.shadowNormalBias=ee.normalBias,ie.shadowRadius=ee.radius,ie.shadowMapSize=ee.mapSize,n.spotShadow[y]=ie,n.spotShadowMap[y]=oe,x++}y++}else if(P.isRectAreaLight){let Y=e.get(P);Y.color.copy(B).multiplyScalar(H),Y.halfWidth.set(P.width*.5,0,0),Y.halfHeight.set(0,P.height*.5,0),n.rectArea[R]=Y,R++}else if(P.isPointLight){let Y=e.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),Y.distance=P.distance,Y.decay=P.decay,P.castShadow){let ee=P.shadow,ie=t.get(P);ie.shadowIntensity=ee.intensity,ie.shadowBias=ee.bias,ie.shadowNormalBias=ee.normalBias,ie.shadowRadius=ee.radius,ie.shadowMapSize=ee.mapSize,ie.shadowCameraNear=ee.camera.near,ie.shadowCameraFar=ee.camera.far,n.pointShadow[p]=ie,n.pointShadowMap[p]=oe,n.pointShadowMatrix[p]=P.shadow.matrix,M++}n.point[p]=Y,p++}else if(P.isHemisphereLight){let Y=e.get(P);Y.skyColor.copy(P.color).multiplyScalar(H),Y.groundColor.copy(P.groundColor).multiplyScalar(H),n.hemi[S]=Y,S++}}R>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Oe.LTC_FLOAT_1,n.rectAreaLTC2=Oe.LTC_FLOAT_2):(n.rectAreaLTC1=Oe.LTC_HALF_1,n.rectAreaLTC2=Oe.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=f,n.ambient[2]=h;let T=n.hash;(T.sunLength!==d||T.directionalLength!==g||T.pointLength!==p||T.spotLength!==y||T.rectAreaLength!==R||T.hemiLength!==S||T.numSunShadows!==m||T.numDirectionalShadows!==b||T.numPointShadows!==M||T.numSpotShadows!==x||T.numSpotMaps!==w||T.numLightProbes!==I)&&(n.sun.length=d,n.directional.length=g,n.spot.length=y,n.rectArea.length=R,n.point.length=p,n.hemi.length=S,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=b,n.directionalShadowMap.length=b,n.directionalShadowMatrix.length=b,n.pointShadow.length=M,n.pointShadowMap.length=M,n.pointShadowMatrix.length=M,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+w-F,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=F,n.numLightProbes=I,T.sunLength=d,T.directionalLength=g,T.pointLength=p,T.spotLength=y,T.rectAreaLength=R,T.hemiLength=S,T.numSunShadows=m,T.numDirectionalShadows=b,T.numPointShadows=M,T.numSpotShadows=x,T.numSpotMaps=w,T.numLightProbes=I,n.version=RM++)}function l(c,u){let f=0,h=0,d=0,m=0,_=0,g=0,p=u.matrixWorldInverse;for(let y=0,R=c.length;y<R;y++){let S=c[y];if(S.isSunLight){let b=n.sun[f];b.direction.setFromMatrixPosition(S.matrixWorld),b.direction.transformDirection(p),f++}else if(S.isDirectionalLight){let b=n.directional[h];b.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(p),h++}else if(S.isSpotLight){let b=n.spot[m];b.position.setFromMatrixPosition(S.matrixWorld),b.position.applyMatrix4(p),b.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(p),m++}else if(S.isRectAreaLight){let b=n.rectArea[_];b.position.setFromMatrixPosition(S.matrixWorld),b.position.applyMatrix4(p),o.identity(),r.copy(S.matrixWorld),r.premultiply(p),o.extractRotation(r),b.halfWidth.set(S.width*.5,0,0),b.halfHeight.set(0,S.height*.5,0),b.halfWidth.applyMatrix4(o),b.halfHeight.applyMatrix4(o),_++}else if(S.isPointLight){let b=n.point[d];b.position.setFromMatrixPosition(S.matrixWorld),b.position.applyMatrix4(p),d++}else if(S.isHemisphereLight){let b=n.hemi[g];b.direction.setFromMatrixPosition(S.matrixWorld),b.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:n}}function gm(i){let e=new IM(i),t=[],n=[],s=[];function r(f){u.camera=f,t.length=0,n.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){n.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function LM(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new gm(i),e.set(s,[a])):r>=o.length?(a=new gm(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var DM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,NM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,UM=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],OM=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],_m=new Et,Ra=new G,hf=new G;function FM(i,e,t){let n=new Vs,s=new Je,r=new Je,o=new Jt,a=new ql,l=new Yl,c={},u=t.maxTextureSize,f={[Ys]:On,[On]:Ys,[yi]:yi},h=new ji({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Je},radius:{value:4}},vertexShader:DM,fragmentShader:NM}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let m=new gn;m.setAttribute("position",new Pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new wt(m,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Sa;let p=this.type;this.render=function(M,x,w){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||M.length===0)return;this.type===fp&&(nt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Sa);let F=i.getRenderTarget(),I=i.getActiveCubeFace(),T=i.getActiveMipmapLevel(),D=i.state;D.setBlending(cr),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let L=p!==this.type;L&&x.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(B=>B.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,B=M.length;P<B;P++){let H=M[P],z=H.shadow;if(z===void 0){nt("WebGLShadowMap:",H,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let oe=z.getFrameExtents();s.multiply(oe),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/oe.x),s.x=r.x*oe.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/oe.y),s.y=r.y*oe.y,z.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=Y,z.map===null||L===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===co){if(H.isPointLight){nt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new ai(s.x,s.y,{format:$s,type:Ni,minFilter:Nn,magFilter:Nn,generateMipmaps:!1}),z.map.texture.name=H.name+".shadowMap",z.map.depthTexture=new xs(s.x,s.y,vi),z.map.depthTexture.name=H.name+".shadowMapDepth",z.map.depthTexture.format=ms,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=In,z.map.depthTexture.magFilter=In}else H.isPointLight?(z.map=new Ia(s.x),z.map.depthTexture=new ca(s.x,Di)):(z.map=new ai(s.x,s.y),z.map.depthTexture=new xs(s.x,s.y,Di)),z.map.depthTexture.name=H.name+".shadowMap",z.map.depthTexture.format=ms,this.type===Sa?(z.map.depthTexture.compareFunction=Y?Zu:$u,z.map.depthTexture.minFilter=Nn,z.map.depthTexture.magFilter=Nn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=In,z.map.depthTexture.magFilter=In);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let ee=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();H.isPointLight!==!0&&z.updateMatrices(H,w);let ie=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:w.layers;for(let j=0;j<ee;j++){let ne=z.getCamera(j);if(H.isPointLight){let q=z.camera,ue=z.matrix,le=H.distance||q.far;le!==q.far&&(q.far=le,q.updateProjectionMatrix()),Ra.setFromMatrixPosition(H.matrixWorld),q.position.copy(Ra),hf.copy(q.position),hf.add(UM[j]),q.up.copy(OM[j]),q.lookAt(hf),q.updateMatrixWorld(),ue.makeTranslation(-Ra.x,-Ra.y,-Ra.z),_m.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),z._frustum.setFromProjectionMatrix(_m,q.coordinateSystem,q.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,j),i.clear();else{j===0&&(i.setRenderTarget(z.map),i.clear());let q=z.getViewport(j);o.set(r.x*q.x,r.y*q.y,r.x*q.z,r.y*q.w),D.viewport(o)}n=z.getFrustum(j),S(x,w,ne,H,ie,this.type)}z.isPointLightShadow!==!0&&this.type===co&&y(z,w),z.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(F,I,T)};function y(M,x){let w=e.update(_);h.defines.VSM_SAMPLES!==M.blurSamples&&(h.defines.VSM_SAMPLES=M.blurSamples,d.defines.VSM_SAMPLES=M.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),M.mapPass===null?M.mapPass=new ai(s.x,s.y,{format:$s,type:Ni}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),h.uniforms.shadow_pass.value=M.map.depthTexture,h.uniforms.resolution.value.set(M.map.width,M.map.height),h.uniforms.radius.value=M.radius,i.setRenderTarget(M.mapPass),i.clear(),i.renderBufferDirect(x,null,w,h,_,null),d.uniforms.shadow_pass.value=M.mapPass.texture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,i.setRenderTarget(M.map),i.clear(),i.renderBufferDirect(x,null,w,d,_,null)}function R(M,x,w,F){let I=null,T=w.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(T!==void 0)I=T;else if(I=w.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let D=I.uuid,L=x.uuid,P=c[D];P===void 0&&(P={},c[D]=P);let B=P[L];B===void 0&&(B=I.clone(),P[L]=B,x.addEventListener("dispose",b)),I=B}if(I.visible=x.visible,I.wireframe=x.wireframe,F===co?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:f[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,w.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let D=i.properties.get(I);D.light=w}return I}function S(M,x,w,F,I,T){if(M.visible===!1)return;if(M.layers.test(I)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&T===co)&&(!M.frustumCulled||M.intersectsFrustum(n))){M.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,M.matrixWorld);let P=e.update(M),B=M.material;if(Array.isArray(B)){let H=P.groups;for(let z=0,oe=H.length;z<oe;z++){let Y=H[z],ee=B[Y.materialIndex];if(ee&&ee.visible){let ie=R(M,ee,F,T);M.onBeforeShadow(i,M,x,w,P,ie,Y),i.renderBufferDirect(w,null,P,ie,M,Y),M.onAfterShadow(i,M,x,w,P,ie,Y)}}}else if(B.visible){let H=R(M,B,F,T);M.onBeforeShadow(i,M,x,w,P,H,null),i.renderBufferDirect(w,null,P,H,M,null),M.onAfterShadow(i,M,x,w,P,H,null)}}let L=M.children;for(let P=0,B=L.length;P<B;P++)S(L[P],x,w,F,I,T)}function b(M){M.target.removeEventListener("dispose",b);for(let w in c){let F=c[w],I=M.target.uuid;I in F&&(F[I].dispose(),delete F[I])}}}function BM(i,e){function t(){let V=!1,ce=new Jt,re=null,Ce=new Jt(0,0,0,0);return{setMask:function(be){re!==be&&!V&&(i.colorMask(be,be,be,be),re=be)},setLocked:function(be){V=be},setClear:function(be,Ae,Ze,ot,ge){ge===!0&&(be*=ot,Ae*=ot,Ze*=ot),ce.set(be,Ae,Ze,ot),Ce.equals(ce)===!1&&(i.clearColor(be,Ae,Ze,ot),Ce.copy(ce))},reset:function(){V=!1,re=null,Ce.set(-1,0,0,0)}}}function n(){let V=!1,ce=!1,re=null,Ce=null,be=null;return{setReversed:function(Ae){if(ce!==Ae){let Ze=e.get("EXT_clip_control");Ae?Ze.clipControlEXT(Ze.LOWER_LEFT_EXT,Ze.ZERO_TO_ONE_EXT):Ze.clipControlEXT(Ze.LOWER_LEFT_EXT,Ze.NEGATIVE_ONE_TO_ONE_EXT),ce=Ae;let ot=be;be=null,this.setClear(ot)}},getReversed:function(){return ce},setTest:function(Ae){Ae?de(i.DEPTH_TEST):Ue(i.DEPTH_TEST)},setMask:function(Ae){re!==Ae&&!V&&(i.depthMask(Ae),re=Ae)},setFunc:function(Ae){if(ce&&(Ae=Xp[Ae]),Ce!==Ae){switch(Ae){case Cl:i.depthFunc(i.NEVER);break;case Rl:i.depthFunc(i.ALWAYS);break;case Pl:i.depthFunc(i.LESS);break;case jr:i.depthFunc(i.LEQUAL);break;case Il:i.depthFunc(i.EQUAL);break;case Ll:i.depthFunc(i.GEQUAL);break;case Dl:i.depthFunc(i.GREATER);break;case Nl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ce=Ae}},setLocked:function(Ae){V=Ae},setClear:function(Ae){be!==Ae&&(be=Ae,ce&&(Ae=1-Ae),i.clearDepth(Ae))},reset:function(){V=!1,re=null,Ce=null,be=null,ce=!1}}}function s(){let V=!1,ce=null,re=null,Ce=null,be=null,Ae=null,Ze=null,ot=null,ge=null;return{setTest:function(Xe){V||(Xe?de(i.STENCIL_TEST):Ue(i.STENCIL_TEST))},setMask:function(Xe){ce!==Xe&&!V&&(i.stencilMask(Xe),ce=Xe)},setFunc:function(Xe,at,Ie){(re!==Xe||Ce!==at||be!==Ie)&&(i.stencilFunc(Xe,at,Ie),re=Xe,Ce=at,be=Ie)},setOp:function(Xe,at,Ie){(Ae!==Xe||Ze!==at||ot!==Ie)&&(i.stencilOp(Xe,at,Ie),Ae=Xe,Ze=at,ot=Ie)},setLocked:function(Xe){V=Xe},setClear:function(Xe){ge!==Xe&&(i.clearStencil(Xe),ge=Xe)},reset:function(){V=!1,ce=null,re=null,Ce=null,be=null,Ae=null,Ze=null,ot=null,ge=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,m=[],_=null,g=!1,p=null,y=null,R=null,S=null,b=null,M=null,x=null,w=new ct(0,0,0),F=0,I=!1,T=null,D=null,L=null,P=null,B=null,H=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,oe=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(oe=parseFloat(/^WebGL (\d)/.exec(Y)[1]),z=oe>=1):Y.indexOf("OpenGL ES")!==-1&&(oe=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),z=oe>=2);let ee=null,ie={},j=i.getParameter(i.SCISSOR_BOX),ne=i.getParameter(i.VIEWPORT),q=new Jt().fromArray(j),ue=new Jt().fromArray(ne);function le(V,ce,re,Ce){let be=new Uint8Array(4),Ae=i.createTexture();i.bindTexture(V,Ae),i.texParameteri(V,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(V,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ze=0;Ze<re;Ze++)V===i.TEXTURE_3D||V===i.TEXTURE_2D_ARRAY?i.texImage3D(ce,0,i.RGBA,1,1,Ce,0,i.RGBA,i.UNSIGNED_BYTE,be):i.texImage2D(ce+Ze,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,be);return Ae}let pe={};pe[i.TEXTURE_2D]=le(i.TEXTURE_2D,i.TEXTURE_2D,1),pe[i.TEXTURE_CUBE_MAP]=le(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),pe[i.TEXTURE_2D_ARRAY]=le(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),pe[i.TEXTURE_3D]=le(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),de(i.DEPTH_TEST),o.setFunc(jr),en(!1),Z(Cu),de(i.CULL_FACE),Bt(cr);function de(V){u[V]!==!0&&(i.enable(V),u[V]=!0)}function Ue(V){u[V]!==!1&&(i.disable(V),u[V]=!1)}function Ve(V,ce){return h[V]!==ce?(i.bindFramebuffer(V,ce),h[V]=ce,V===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=ce),V===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=ce),!0):!1}function De(V,ce){let re=m,Ce=!1;if(V){re=d.get(ce),re===void 0&&(re=[],d.set(ce,re));let be=V.textures;if(re.length!==be.length||re[0]!==i.COLOR_ATTACHMENT0){for(let Ae=0,Ze=be.length;Ae<Ze;Ae++)re[Ae]=i.COLOR_ATTACHMENT0+Ae;re.length=be.length,Ce=!0}}else re[0]!==i.BACK&&(re[0]=i.BACK,Ce=!0);Ce&&i.drawBuffers(re)}function Qe(V){return _!==V?(i.useProgram(V),_=V,!0):!1}let tt={[hr]:i.FUNC_ADD,[pp]:i.FUNC_SUBTRACT,[mp]:i.FUNC_REVERSE_SUBTRACT};tt[gp]=i.MIN,tt[_p]=i.MAX;let Be={[xp]:i.ZERO,[yp]:i.ONE,[vp]:i.SRC_COLOR,[Lu]:i.SRC_ALPHA,[Tp]:i.SRC_ALPHA_SATURATE,[wp]:i.DST_COLOR,[Mp]:i.DST_ALPHA,[Sp]:i.ONE_MINUS_SRC_COLOR,[Du]:i.ONE_MINUS_SRC_ALPHA,[Ep]:i.ONE_MINUS_DST_COLOR,[bp]:i.ONE_MINUS_DST_ALPHA,[Ap]:i.CONSTANT_COLOR,[Cp]:i.ONE_MINUS_CONSTANT_COLOR,[Rp]:i.CONSTANT_ALPHA,[Pp]:i.ONE_MINUS_CONSTANT_ALPHA};function Bt(V,ce,re,Ce,be,Ae,Ze,ot,ge,Xe){if(V===cr){g===!0&&(Ue(i.BLEND),g=!1);return}if(g===!1&&(de(i.BLEND),g=!0),V!==dp){if(V!==p||Xe!==I){if((y!==hr||b!==hr)&&(i.blendEquation(i.FUNC_ADD),y=hr,b=hr),Xe)switch(V){case ho:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ru:i.blendFunc(i.ONE,i.ONE);break;case Pu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Iu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:rt("WebGLState: Invalid blending: ",V);break}else switch(V){case ho:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ru:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Pu:rt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Iu:rt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:rt("WebGLState: Invalid blending: ",V);break}R=null,S=null,M=null,x=null,w.set(0,0,0),F=0,p=V,I=Xe}return}be=be||ce,Ae=Ae||re,Ze=Ze||Ce,(ce!==y||be!==b)&&(i.blendEquationSeparate(tt[ce],tt[be]),y=ce,b=be),(re!==R||Ce!==S||Ae!==M||Ze!==x)&&(i.blendFuncSeparate(Be[re],Be[Ce],Be[Ae],Be[Ze]),R=re,S=Ce,M=Ae,x=Ze),(ot.equals(w)===!1||ge!==F)&&(i.blendColor(ot.r,ot.g,ot.b,ge),w.copy(ot),F=ge),p=V,I=!1}function Dt(V,ce){V.side===yi?Ue(i.CULL_FACE):de(i.CULL_FACE);let re=V.side===On;ce&&(re=!re),en(re),V.blending===ho&&V.transparent===!1?Bt(cr):Bt(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Ce=V.stencilWrite;a.setTest(Ce),Ce&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),Se(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?de(i.SAMPLE_ALPHA_TO_COVERAGE):Ue(i.SAMPLE_ALPHA_TO_COVERAGE)}function en(V){T!==V&&(V?i.frontFace(i.CW):i.frontFace(i.CCW),T=V)}function Z(V){V!==hp?(de(i.CULL_FACE),V!==D&&(V===Cu?i.cullFace(i.BACK):V===up?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ue(i.CULL_FACE),D=V}function me(V){V!==L&&(z&&i.lineWidth(V),L=V)}function Se(V,ce,re){V?(de(i.POLYGON_OFFSET_FILL),(P!==ce||B!==re)&&(P=ce,B=re,o.getReversed()&&(ce=-ce,re=-re),i.polygonOffset(ce,re))):Ue(i.POLYGON_OFFSET_FILL)}function Ke(V){V?de(i.SCISSOR_TEST):Ue(i.SCISSOR_TEST)}function it(V){V===void 0&&(V=i.TEXTURE0+H-1),ee!==V&&(i.activeTexture(V),ee=V)}function gt(V,ce,re){re===void 0&&(ee===null?re=i.TEXTURE0+H-1:re=ee);let Ce=ie[re];Ce===void 0&&(Ce={type:void 0,texture:void 0},ie[re]=Ce),(Ce.type!==V||Ce.texture!==ce)&&(ee!==re&&(i.activeTexture(re),ee=re),i.bindTexture(V,ce||pe[V]),Ce.type=V,Ce.texture=ce)}function k(){let V=ie[ee];V!==void 0&&V.type!==void 0&&(i.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Me(){try{i.compressedTexImage2D(...arguments)}catch(V){rt("WebGLState:",V)}}function $e(){try{i.compressedTexImage3D(...arguments)}catch(V){rt("WebGLState:",V)}}function We(){try{i.texSubImage2D(...arguments)}catch(V){rt("WebGLState:",V)}}function ye(){try{i.texSubImage3D(...arguments)}catch(V){rt("WebGLState:",V)}}function mt(){try{i.compressedTexSubImage2D(...arguments)}catch(V){rt("WebGLState:",V)}}function ke(){try{i.compressedTexSubImage3D(...arguments)}catch(V){rt("WebGLState:",V)}}function et(){try{i.texStorage2D(...arguments)}catch(V){rt("WebGLState:",V)}}function N(){try{i.texStorage3D(...arguments)}catch(V){rt("WebGLState:",V)}}function E(){try{i.texImage2D(...arguments)}catch(V){rt("WebGLState:",V)}}function $(){try{i.texImage3D(...arguments)}catch(V){rt("WebGLState:",V)}}function _e(V){return f[V]!==void 0?f[V]:i.getParameter(V)}function he(V,ce){f[V]!==ce&&(i.pixelStorei(V,ce),f[V]=ce)}function we(V){q.equals(V)===!1&&(i.scissor(V.x,V.y,V.z,V.w),q.copy(V))}function Ee(V){ue.equals(V)===!1&&(i.viewport(V.x,V.y,V.z,V.w),ue.copy(V))}function se(V,ce){let re=c.get(ce);re===void 0&&(re=new WeakMap,c.set(ce,re));let Ce=re.get(V);Ce===void 0&&(Ce=i.getUniformBlockIndex(ce,V.name),i.uniformBlockBinding(ce,Ce,Ce),re.set(V,Ce))}function ae(V,ce,re){let be=c.get(ce).get(V);l[be]!==re&&(i.bindBufferBase(i.UNIFORM_BUFFER,be,re),l[be]=re)}function ve(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},f={},ee=null,ie={},h={},l={},d=new WeakMap,m=[],_=null,g=!1,p=null,y=null,R=null,S=null,b=null,M=null,x=null,w=new ct(0,0,0),F=0,I=!1,T=null,D=null,L=null,P=null,B=null,q.set(0,0,i.canvas.width,i.canvas.height),ue.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:de,disable:Ue,bindFramebuffer:Ve,drawBuffers:De,useProgram:Qe,setBlending:Bt,setMaterial:Dt,setFlipSided:en,setCullFace:Z,setLineWidth:me,setPolygonOffset:Se,setScissorTest:Ke,activeTexture:it,bindTexture:gt,unbindTexture:k,compressedTexImage2D:Me,compressedTexImage3D:$e,texImage2D:E,texImage3D:$,pixelStorei:he,getParameter:_e,updateUBOMapping:se,uniformBlockBinding:ae,texStorage2D:et,texStorage3D:N,texSubImage2D:We,texSubImage3D:ye,compressedTexSubImage2D:mt,compressedTexSubImage3D:ke,scissor:we,viewport:Ee,reset:ve}}function kM(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Je,u=new WeakMap,f=new Set,h,d=new WeakMap,m=new Set,_=new FinalizationRegistry(N=>m.delete(N)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(N,E){return g?new OffscreenCanvas(N,E):Ko("canvas")}function y(N,E,$){let _e=1,he=et(N);if((he.width>$||he.height>$)&&(_e=$/Math.max(he.width,he.height)),_e<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let we=Math.floor(_e*he.width),Ee=Math.floor(_e*he.height);h===void 0&&(h=p(we,Ee));let se=E?p(we,Ee):h;return se.width=we,se.height=Ee,se.getContext("2d").drawImage(N,0,0,we,Ee),nt("WebGLRenderer: Texture has been resized from ("+he.width+"x"+he.height+") to ("+we+"x"+Ee+")."),se}else return"data"in N&&nt("WebGLRenderer: Image in DataTexture is too big ("+he.width+"x"+he.height+")."),N;return N}function R(N){return N.generateMipmaps}function S(N){i.generateMipmap(N)}function b(N){return N.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?i.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(N,E,$,_e,he,we=!1){if(N!==null){if(i[N]!==void 0)return i[N];nt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let Ee;_e&&(Ee=e.get("EXT_texture_norm16"),Ee||nt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let se=E;if(E===i.RED&&($===i.FLOAT&&(se=i.R32F),$===i.HALF_FLOAT&&(se=i.R16F),$===i.UNSIGNED_BYTE&&(se=i.R8),$===i.UNSIGNED_SHORT&&Ee&&(se=Ee.R16_EXT),$===i.SHORT&&Ee&&(se=Ee.R16_SNORM_EXT)),E===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(se=i.R8UI),$===i.UNSIGNED_SHORT&&(se=i.R16UI),$===i.UNSIGNED_INT&&(se=i.R32UI),$===i.BYTE&&(se=i.R8I),$===i.SHORT&&(se=i.R16I),$===i.INT&&(se=i.R32I)),E===i.RG&&($===i.FLOAT&&(se=i.RG32F),$===i.HALF_FLOAT&&(se=i.RG16F),$===i.UNSIGNED_BYTE&&(se=i.RG8),$===i.UNSIGNED_SHORT&&Ee&&(se=Ee.RG16_EXT),$===i.SHORT&&Ee&&(se=Ee.RG16_SNORM_EXT)),E===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(se=i.RG8UI),$===i.UNSIGNED_SHORT&&(se=i.RG16UI),$===i.UNSIGNED_INT&&(se=i.RG32UI),$===i.BYTE&&(se=i.RG8I),$===i.SHORT&&(se=i.RG16I),$===i.INT&&(se=i.RG32I)),E===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(se=i.RGB8UI),$===i.UNSIGNED_SHORT&&(se=i.RGB16UI),$===i.UNSIGNED_INT&&(se=i.RGB32UI),$===i.BYTE&&(se=i.RGB8I),$===i.SHORT&&(se=i.RGB16I),$===i.INT&&(se=i.RGB32I)),E===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(se=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(se=i.RGBA16UI),$===i.UNSIGNED_INT&&(se=i.RGBA32UI),$===i.BYTE&&(se=i.RGBA8I),$===i.SHORT&&(se=i.RGBA16I),$===i.INT&&(se=i.RGBA32I)),E===i.RGB&&($===i.UNSIGNED_SHORT&&Ee&&(se=Ee.RGB16_EXT),$===i.SHORT&&Ee&&(se=Ee.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(se=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(se=i.R11F_G11F_B10F)),E===i.RGBA){let ae=we?Jo:Mt.getTransfer(he);$===i.FLOAT&&(se=i.RGBA32F),$===i.HALF_FLOAT&&(se=i.RGBA16F),$===i.UNSIGNED_BYTE&&(se=ae===It?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&Ee&&(se=Ee.RGBA16_EXT),$===i.SHORT&&Ee&&(se=Ee.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(se=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(se=i.RGB5_A1)}return(se===i.R16F||se===i.R32F||se===i.RG16F||se===i.RG32F||se===i.RGBA16F||se===i.RGBA32F)&&e.get("EXT_color_buffer_float"),se}function x(N,E){let $;return N?E===null||E===Di||E===fr?$=i.DEPTH24_STENCIL8:E===vi?$=i.DEPTH32F_STENCIL8:E===fo&&($=i.DEPTH24_STENCIL8,nt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===Di||E===fr?$=i.DEPTH_COMPONENT24:E===vi?$=i.DEPTH_COMPONENT32F:E===fo&&($=i.DEPTH_COMPONENT16),$}function w(N,E){return R(N)===!0||N.isFramebufferTexture&&N.minFilter!==In&&N.minFilter!==Nn?Math.log2(Math.max(E.width,E.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?E.mipmaps.length:1}function F(N){let E=new WeakRef(N);n.get(N).__ref=E,m.add(E),_.register(N,E,E)}function I(N){let E=n.get(N).__ref;E!==void 0&&(m.delete(E),_.unregister(E))}function T(N){L(N.target)}function D(N){P(N.target)}function L(N){N.removeEventListener("dispose",T),I(N),H(N),N.isVideoTexture&&u.delete(N),N.isHTMLTexture&&f.delete(N)}function P(N){N.removeEventListener("dispose",D),I(N),oe(N)}function B(){for(let N of m){let E=N.deref();E!==void 0&&(E.isRenderTarget===!0?P(E):L(E))}m.clear(),f.clear()}function H(N){let E=n.get(N);if(E.__webglInit===void 0)return;let $=N.source,_e=d.get($);if(_e){let he=_e[E.__cacheKey];he.usedTimes--,he.usedTimes===0&&z(N),Object.keys(_e).length===0&&d.delete($)}n.remove(N)}function z(N){let E=n.get(N);i.deleteTexture(E.__webglTexture);let $=N.source,_e=d.get($);delete _e[E.__cacheKey],o.memory.textures--}function oe(N){let E=n.get(N);E.__depthDisposeCallback&&E.__depthDisposeCallback();let $=N.depthTexture;if($&&$.renderTarget===N&&L($),N.isWebGLCubeRenderTarget)for(let he=0;he<6;he++){if(Array.isArray(E.__webglFramebuffer[he]))for(let we=0;we<E.__webglFramebuffer[he].length;we++)i.deleteFramebuffer(E.__webglFramebuffer[he][we]);else i.deleteFramebuffer(E.__webglFramebuffer[he]);E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer[he])}else{if(Array.isArray(E.__webglFramebuffer))for(let he=0;he<E.__webglFramebuffer.length;he++)i.deleteFramebuffer(E.__webglFramebuffer[he]);else i.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&i.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let he=0;he<E.__webglColorRenderbuffer.length;he++)E.__webglColorRenderbuffer[he]&&i.deleteRenderbuffer(E.__webglColorRenderbuffer[he]);E.__webglDepthRenderbuffer&&i.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let _e=N.textures;for(let he=0,we=_e.length;he<we;he++){let Ee=n.get(_e[he]);Ee.__webglTexture&&(i.deleteTexture(Ee.__webglTexture),o.memory.textures--),n.remove(_e[he])}n.remove(N)}let Y=0;function ee(){Y=0}function ie(){return Y}function j(N){Y=N}function ne(){let N=Y;return N>=s.maxTextures&&nt("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,N}function q(N){let E=[];return E.push(N.wrapS),E.push(N.wrapT),E.push(N.wrapR||0),E.push(N.magFilter),E.push(N.minFilter),E.push(N.anisotropy),E.push(N.internalFormat),E.push(N.format),E.push(N.type),E.push(N.generateMipmaps),E.push(N.mipmapsAutoUpdate),E.push(N.premultiplyAlpha),E.push(N.flipY),E.push(N.unpackAlignment),E.push(N.colorSpace),E.join()}function ue(N,E){let $=n.get(N);if(N.isVideoTexture&&mt(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&$.__version!==N.version){let _e=N.image;if(_e===null)nt("WebGLRenderer: Texture marked for update but no image data found.");else if(_e.complete===!1)nt("WebGLRenderer: Texture marked for update but image is incomplete");else{Dt($,N,E);return}}else N.isExternalTexture&&($.__webglTexture=N.sourceTexture?N.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+E)}function le(N,E){let $=n.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&$.__version!==N.version){Dt($,N,E);return}else N.isExternalTexture&&($.__webglTexture=N.sourceTexture?N.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+E)}function pe(N,E){let $=n.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&$.__version!==N.version){Dt($,N,E);return}t.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+E)}function de(N,E){let $=n.get(N);if(N.version>0&&$.__version!==N.version){en($,N,E);return}t.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+E)}let Ue={[Ul]:i.REPEAT,[Ji]:i.CLAMP_TO_EDGE,[Ol]:i.MIRRORED_REPEAT},Ve={[In]:i.NEAREST,[Dp]:i.NEAREST_MIPMAP_NEAREST,[Ma]:i.NEAREST_MIPMAP_LINEAR,[Nn]:i.LINEAR,[cc]:i.LINEAR_MIPMAP_NEAREST,[vs]:i.LINEAR_MIPMAP_LINEAR},De={[Fp]:i.NEVER,[Ju]:i.ALWAYS,[Bp]:i.LESS,[$u]:i.LEQUAL,[kp]:i.EQUAL,[Zu]:i.GEQUAL,[zp]:i.GREATER,[Vp]:i.NOTEQUAL};function Qe(N,E){if(E.type===vi&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===Nn||E.magFilter===cc||E.magFilter===Ma||E.magFilter===vs||E.minFilter===Nn||E.minFilter===cc||E.minFilter===Ma||E.minFilter===vs)&&nt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(N,i.TEXTURE_WRAP_S,Ue[E.wrapS]),i.texParameteri(N,i.TEXTURE_WRAP_T,Ue[E.wrapT]),(N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY)&&i.texParameteri(N,i.TEXTURE_WRAP_R,Ue[E.wrapR]),i.texParameteri(N,i.TEXTURE_MAG_FILTER,Ve[E.magFilter]),i.texParameteri(N,i.TEXTURE_MIN_FILTER,Ve[E.minFilter]),E.compareFunction&&(i.texParameteri(N,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(N,i.TEXTURE_COMPARE_FUNC,De[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===In||E.minFilter!==Ma&&E.minFilter!==vs||E.type===vi&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||n.get(E).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");i.texParameterf(N,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),n.get(E).__currentAnisotropy=E.anisotropy}}}function tt(N,E){let $=!1;N.__webglInit===void 0&&(N.__webglInit=!0,E.addEventListener("dispose",T),F(E));let _e=E.source,he=d.get(_e);he===void 0&&(he={},d.set(_e,he));let we=q(E);if(we!==N.__cacheKey){he[we]===void 0&&(he[we]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),he[we].usedTimes++;let Ee=he[N.__cacheKey];Ee!==void 0&&(he[N.__cacheKey].usedTimes--,Ee.usedTimes===0&&z(E)),N.__cacheKey=we,N.__webglTexture=he[we].texture}return $}function Be(N,E,$){return Math.floor(Math.floor(N/$)/E)}function Bt(N,E,$,_e){let we=N.updateRanges;if(we.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,E.width,E.height,$,_e,E.data);else{we.sort((V,ce)=>V.start-ce.start);let Ee=0;for(let V=1;V<we.length;V++){let ce=we[Ee],re=we[V],Ce=ce.start+ce.count,be=Be(re.start,E.width,4),Ae=Be(ce.start,E.width,4);re.start<=Ce+1&&be===Ae&&Be(re.start+re.count-1,E.width,4)===be?ce.count=Math.max(ce.count,re.start+re.count-ce.start):(++Ee,we[Ee]=re)}we.length=Ee+1;let se=t.getParameter(i.UNPACK_ROW_LENGTH),ae=t.getParameter(i.UNPACK_SKIP_PIXELS),ve=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,E.width);for(let V=0,ce=we.length;V<ce;V++){let re=we[V],Ce=Math.floor(re.start/4),be=Math.ceil(re.count/4),Ae=Ce%E.width,Ze=Math.floor(Ce/E.width),ot=be,ge=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ze),t.texSubImage2D(i.TEXTURE_2D,0,Ae,Ze,ot,ge,$,_e,E.data)}N.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,se),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,ve)}}function Dt(N,E,$){let _e=i.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(_e=i.TEXTURE_2D_ARRAY),E.isData3DTexture&&(_e=i.TEXTURE_3D);let he=tt(N,E),we=E.source;t.bindTexture(_e,N.__webglTexture,i.TEXTURE0+$);let Ee=n.get(we);if(we.version!==Ee.__version||he===!0){if(t.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let ge=Mt.getPrimaries(Mt.workingColorSpace),Xe=E.colorSpace===Ms?null:Mt.getPrimaries(E.colorSpace),at=E.colorSpace===Ms||ge===Xe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,at)}t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment);let ae=y(E.image,!1,s.maxTextureSize);ae=ke(E,ae);let ve=r.convert(E.format,E.colorSpace),V=r.convert(E.type),ce=M(E.internalFormat,ve,V,E.normalized,E.colorSpace,E.isVideoTexture);Qe(_e,E);let re,Ce=E.mipmaps,be=E.isVideoTexture!==!0,Ae=Ee.__version===void 0||he===!0,Ze=we.dataReady,ot=w(E,ae);if(E.isDepthTexture)ce=x(E.format===Ss,E.type),Ae&&(be?t.texStorage2D(i.TEXTURE_2D,1,ce,ae.width,ae.height):t.texImage2D(i.TEXTURE_2D,0,ce,ae.width,ae.height,0,ve,V,null));else if(E.isDataTexture)if(Ce.length>0){be&&Ae&&t.texStorage2D(i.TEXTURE_2D,ot,ce,Ce[0].width,Ce[0].height);for(let ge=0,Xe=Ce.length;ge<Xe;ge++)re=Ce[ge],be?Ze&&t.texSubImage2D(i.TEXTURE_2D,ge,0,0,re.width,re.height,ve,V,re.data):t.texImage2D(i.TEXTURE_2D,ge,ce,re.width,re.height,0,ve,V,re.data);E.generateMipmaps=!1}else be?(Ae&&t.texStorage2D(i.TEXTURE_2D,ot,ce,ae.width,ae.height),Ze&&Bt(E,ae,ve,V)):t.texImage2D(i.TEXTURE_2D,0,ce,ae.width,ae.height,0,ve,V,ae.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){be&&Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ot,ce,Ce[0].width,Ce[0].height,ae.depth);for(let ge=0,Xe=Ce.length;ge<Xe;ge++)if(re=Ce[ge],E.format!==Ui)if(ve!==null)if(be){if(Ze)if(E.layerUpdates.size>0){let at=lf(re.width,re.height,E.format,E.type);for(let Ie of E.layerUpdates){let ft=re.data.subarray(Ie*at/re.data.BYTES_PER_ELEMENT,(Ie+1)*at/re.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ge,0,0,Ie,re.width,re.height,1,ve,ft)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ge,0,0,0,re.width,re.height,ae.depth,ve,re.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ge,ce,re.width,re.height,ae.depth,0,re.data,0,0);else nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else be?Ze&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ge,0,0,0,re.width,re.height,ae.depth,ve,V,re.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ge,ce,re.width,re.height,ae.depth,0,ve,V,re.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{be&&Ae&&t.texStorage2D(i.TEXTURE_2D,ot,ce,Ce[0].width,Ce[0].height);for(let ge=0,Xe=Ce.length;ge<Xe;ge++)re=Ce[ge],E.format!==Ui?ve!==null?be?Ze&&t.compressedTexSubImage2D(i.TEXTURE_2D,ge,0,0,re.width,re.height,ve,re.data):t.compressedTexImage2D(i.TEXTURE_2D,ge,ce,re.width,re.height,0,re.data):nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):be?Ze&&t.texSubImage2D(i.TEXTURE_2D,ge,0,0,re.width,re.height,ve,V,re.data):t.texImage2D(i.TEXTURE_2D,ge,ce,re.width,re.height,0,ve,V,re.data)}else if(E.isDataArrayTexture)if(be){if(Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ot,ce,ae.width,ae.height,ae.depth),Ze)if(E.layerUpdates.size>0){let ge=lf(ae.width,ae.height,E.format,E.type);for(let Xe of E.layerUpdates){let at=ae.data.subarray(Xe*ge/ae.data.BYTES_PER_ELEMENT,(Xe+1)*ge/ae.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Xe,ae.width,ae.height,1,ve,V,at)}E.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ae.width,ae.height,ae.depth,ve,V,ae.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ce,ae.width,ae.height,ae.depth,0,ve,V,ae.data);else if(E.isData3DTexture)be?(Ae&&t.texStorage3D(i.TEXTURE_3D,ot,ce,ae.width,ae.height,ae.depth),Ze&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ae.width,ae.height,ae.depth,ve,V,ae.data)):t.texImage3D(i.TEXTURE_3D,0,ce,ae.width,ae.height,ae.depth,0,ve,V,ae.data);else if(E.isFramebufferTexture){if(Ae)if(be)t.texStorage2D(i.TEXTURE_2D,ot,ce,ae.width,ae.height);else{let ge=ae.width,Xe=ae.height;for(let at=0;at<ot;at++)t.texImage2D(i.TEXTURE_2D,at,ce,ge,Xe,0,ve,V,null),ge>>=1,Xe>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in i){let ge=i.canvas;if(ge.hasAttribute("layoutsubtree")||ge.setAttribute("layoutsubtree","true"),ae.parentNode!==ge){ge.appendChild(ae),f.add(E),ge.onpaint=Xe=>{let at=Xe.changedElements;for(let Ie of f)at.includes(Ie.image)&&(Ie.needsUpdate=!0)},ge.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ae);else{let at=i.RGBA,Ie=i.RGBA,ft=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,at,Ie,ft,ae)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ce.length>0){if(be&&Ae){let ge=et(Ce[0]);t.texStorage2D(i.TEXTURE_2D,ot,ce,ge.width,ge.height)}for(let ge=0,Xe=Ce.length;ge<Xe;ge++)re=Ce[ge],be?Ze&&t.texSubImage2D(i.TEXTURE_2D,ge,0,0,ve,V,re):t.texImage2D(i.TEXTURE_2D,ge,ce,ve,V,re);E.generateMipmaps=!1}else if(be){if(Ae){let ge=et(ae);t.texStorage2D(i.TEXTURE_2D,ot,ce,ge.width,ge.height)}Ze&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ve,V,ae)}else t.texImage2D(i.TEXTURE_2D,0,ce,ve,V,ae);R(E)&&E.mipmapsAutoUpdate===!0&&S(_e),Ee.__version=we.version,E.onUpdate&&E.onUpdate(E)}N.__version=E.version}function en(N,E,$){if(E.image.length!==6)return;let _e=tt(N,E),he=E.source;t.bindTexture(i.TEXTURE_CUBE_MAP,N.__webglTexture,i.TEXTURE0+$);let we=n.get(he);if(he.version!==we.__version||_e===!0){t.activeTexture(i.TEXTURE0+$);let Ee=Mt.getPrimaries(Mt.workingColorSpace),se=E.colorSpace===Ms?null:Mt.getPrimaries(E.colorSpace),ae=E.colorSpace===Ms||Ee===se?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae);let ve=E.isCompressedTexture||E.image[0].isCompressedTexture,V=E.image[0]&&E.image[0].isDataTexture,ce=[];for(let Ie=0;Ie<6;Ie++)!ve&&!V?ce[Ie]=y(E.image[Ie],!0,s.maxCubemapSize):ce[Ie]=V?E.image[Ie].image:E.image[Ie],ce[Ie]=ke(E,ce[Ie]);let re=ce[0],Ce=r.convert(E.format,E.colorSpace),be=r.convert(E.type),Ae=M(E.internalFormat,Ce,be,E.normalized,E.colorSpace),Ze=E.isVideoTexture!==!0,ot=we.__version===void 0||_e===!0,ge=he.dataReady,Xe=w(E,re);Qe(i.TEXTURE_CUBE_MAP,E);let at;if(E.isDepthTexture){if(Ae=x(E.format===Ss,E.type),ot)if(Ze)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ae,re.width,re.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Ae,re.width,re.height,0,Ce,be,null)}else if(ve){Ze&&ot&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Xe,Ae,re.width,re.height);for(let Ie=0;Ie<6;Ie++){at=ce[Ie].mipmaps;for(let ft=0;ft<at.length;ft++){let Gt=at[ft];E.format!==Ui?Ce!==null?Ze?ge&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft,0,0,Gt.width,Gt.height,Ce,Gt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft,Ae,Gt.width,Gt.height,0,Gt.data):nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ze?ge&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft,0,0,Gt.width,Gt.height,Ce,be,Gt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft,Ae,Gt.width,Gt.height,0,Ce,be,Gt.data)}}}else{if(at=E.mipmaps,Ze&&ot){at.length>0&&Xe++;let Ie=et(ce[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Xe,Ae,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(V){Ze?ge&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,ce[Ie].width,ce[Ie].height,Ce,be,ce[Ie].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Ae,ce[Ie].width,ce[Ie].height,0,Ce,be,ce[Ie].data);for(let ft=0;ft<at.length;ft++){let Hn=at[ft].image[Ie].image;Ze?ge&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft+1,0,0,Hn.width,Hn.height,Ce,be,Hn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft+1,Ae,Hn.width,Hn.height,0,Ce,be,Hn.data)}}else{Ze?ge&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Ce,be,ce[Ie]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Ae,Ce,be,ce[Ie]);for(let ft=0;ft<at.length;ft++){let Gt=at[ft];Ze?ge&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft+1,0,0,Ce,be,Gt.image[Ie]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft+1,Ae,Ce,be,Gt.image[Ie])}}}R(E)&&E.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),we.__version=he.version,E.onUpdate&&E.onUpdate(E)}N.__version=E.version}function Z(N,E,$,_e,he,we){let Ee=r.convert($.format,$.colorSpace),se=r.convert($.type),ae=M($.internalFormat,Ee,se,$.normalized,$.colorSpace),ve=n.get(E),V=n.get($);if(V.__renderTarget=E,!ve.__hasExternalTextures){let ce=Math.max(1,E.width>>we),re=Math.max(1,E.height>>we);he===i.TEXTURE_3D||he===i.TEXTURE_2D_ARRAY?t.texImage3D(he,we,ae,ce,re,E.depth,0,Ee,se,null):t.texImage2D(he,we,ae,ce,re,0,Ee,se,null)}t.bindFramebuffer(i.FRAMEBUFFER,N),ye(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_e,he,V.__webglTexture,0,We(E)):(he===i.TEXTURE_2D||he>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&he<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,_e,he,V.__webglTexture,we),t.bindFramebuffer(i.FRAMEBUFFER,null)}function me(N,E,$){if(i.bindRenderbuffer(i.RENDERBUFFER,N),E.depthBuffer){let _e=E.depthTexture,he=_e&&_e.isDepthTexture?_e.type:null,we=x(E.stencilBuffer,he),Ee=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ye(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,We(E),we,E.width,E.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,We(E),we,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,we,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Ee,i.RENDERBUFFER,N)}else{let _e=E.textures;for(let he=0;he<_e.length;he++){let we=_e[he],Ee=r.convert(we.format,we.colorSpace),se=r.convert(we.type),ae=M(we.internalFormat,Ee,se,we.normalized,we.colorSpace);ye(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,We(E),ae,E.width,E.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,We(E),ae,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,ae,E.width,E.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Se(N,E,$){let _e=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,N),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let he=n.get(E.depthTexture);he.__renderTarget=E;let we=_e?E.depthTexture.image[0]:E.depthTexture.image;(!he.__webglTexture||we.width!==E.width||we.height!==E.height)&&(we.width=E.width,we.height=E.height,E.depthTexture.needsUpdate=!0),_e?de(E.depthTexture,0):ue(E.depthTexture,0);let Ee=he.__webglTexture,se=We(E),ae=_e?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,ve=E.depthTexture.format===Ss?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(E.depthTexture.format===ms)ye(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ve,ae,Ee,0,se):i.framebufferTexture2D(i.FRAMEBUFFER,ve,ae,Ee,0);else if(E.depthTexture.format===Ss)ye(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ve,ae,Ee,0,se):i.framebufferTexture2D(i.FRAMEBUFFER,ve,ae,Ee,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ke(N){let E=n.get(N),$=N.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==N.depthTexture){let _e=N.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),_e){let he=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,_e.removeEventListener("dispose",he)};_e.addEventListener("dispose",he),E.__depthDisposeCallback=he}E.__boundDepthTexture=_e}if(N.depthTexture&&!E.__autoAllocateDepthBuffer)if($)for(let _e=0;_e<6;_e++)Se(E.__webglFramebuffer[_e],N,_e);else N.texture.mipmaps.length>0?Se(E.__webglFramebuffer[0],N,0):Se(E.__webglFramebuffer,N,0);else if($){E.__webglDepthbuffer=[];for(let _e=0;_e<6;_e++)if(t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[_e]),E.__webglDepthbuffer[_e]===void 0)E.__webglDepthbuffer[_e]=i.createRenderbuffer(),me(E.__webglDepthbuffer[_e],N,!1);else{let he=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,we=E.__webglDepthbuffer[_e];i.bindRenderbuffer(i.RENDERBUFFER,we),i.framebufferRenderbuffer(i.FRAMEBUFFER,he,i.RENDERBUFFER,we)}}else if(N.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=i.createRenderbuffer(),me(E.__webglDepthbuffer,N,!1);else{let he=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,we=E.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,we),i.framebufferRenderbuffer(i.FRAMEBUFFER,he,i.RENDERBUFFER,we)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function it(N,E,$){let _e=n.get(N);E!==void 0&&Z(_e.__webglFramebuffer,N,N.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&Ke(N)}function gt(N){let E=N.texture,$=n.get(N),_e=n.get(E);N.addEventListener("dispose",D),F(N);let he=N.textures,we=N.isWebGLCubeRenderTarget===!0,Ee=he.length>1;if(Ee||(_e.__webglTexture===void 0&&(_e.__webglTexture=i.createTexture()),_e.__version=E.version,o.memory.textures++),we){$.__webglFramebuffer=[];for(let se=0;se<6;se++)if(E.mipmaps.length>0){$.__webglFramebuffer[se]=[];for(let ae=0;ae<E.mipmaps.length;ae++)$.__webglFramebuffer[se][ae]=i.createFramebuffer()}else $.__webglFramebuffer[se]=i.createFramebuffer()}else{if(E.mipmaps.length>0){$.__webglFramebuffer=[];for(let se=0;se<E.mipmaps.length;se++)$.__webglFramebuffer[se]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(Ee)for(let se=0,ae=he.length;se<ae;se++){let ve=n.get(he[se]);ve.__webglTexture===void 0&&(ve.__webglTexture=i.createTexture(),o.memory.textures++)}if(N.samples>0&&ye(N)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let se=0;se<he.length;se++){let ae=he[se];$.__webglColorRenderbuffer[se]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[se]);let ve=r.convert(ae.format,ae.colorSpace),V=r.convert(ae.type),ce=M(ae.internalFormat,ve,V,ae.normalized,ae.colorSpace,N.isXRRenderTarget===!0),re=We(N);i.renderbufferStorageMultisample(i.RENDERBUFFER,re,ce,N.width,N.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+se,i.RENDERBUFFER,$.__webglColorRenderbuffer[se])}i.bindRenderbuffer(i.RENDERBUFFER,null),N.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),me($.__webglDepthRenderbuffer,N,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(we){t.bindTexture(i.TEXTURE_CUBE_MAP,_e.__webglTexture),Qe(i.TEXTURE_CUBE_MAP,E);for(let se=0;se<6;se++)if(E.mipmaps.length>0)for(let ae=0;ae<E.mipmaps.length;ae++)Z($.__webglFramebuffer[se][ae],N,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+se,ae);else Z($.__webglFramebuffer[se],N,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+se,0);R(E)?S(i.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}else if(Ee){for(let se=0,ae=he.length;se<ae;se++){let ve=he[se],V=n.get(ve),ce=i.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(ce=N.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ce,V.__webglTexture),Qe(ce,ve),Z($.__webglFramebuffer,N,ve,i.COLOR_ATTACHMENT0+se,ce,0),R(ve)&&S(ce)}t.unbindTexture()}else{let se=i.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(se=N.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(se,_e.__webglTexture),Qe(se,E),E.mipmaps.length>0)for(let ae=0;ae<E.mipmaps.length;ae++)Z($.__webglFramebuffer[ae],N,E,i.COLOR_ATTACHMENT0,se,ae);else Z($.__webglFramebuffer,N,E,i.COLOR_ATTACHMENT0,se,0);R(E)?S(se):E.mipmaps.length>0&&i.texParameteri(se,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}N.depthBuffer&&Ke(N)}function k(N){let E=N.textures;for(let $=0,_e=E.length;$<_e;$++){let he=E[$];if(R(he)&&he.mipmapsAutoUpdate===!0){let we=b(N),Ee=n.get(he).__webglTexture;t.bindTexture(we,Ee),S(we),t.unbindTexture()}}}let Me=[];function $e(N){if(N.samples>0){if(ye(N)===!1){let E=N.textures,$=N.width,_e=N.height,he=i.COLOR_BUFFER_BIT,we=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ee=n.get(N),se=E.length>1;if(se)for(let ve=0;ve<E.length;ve++)t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ve,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ve,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Ee.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ee.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ee.__webglFramebuffer);for(let ve=0;ve<E.length;ve++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(he|=i.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(he|=i.STENCIL_BUFFER_BIT)),se){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Ee.__webglColorRenderbuffer[ve]);let V=n.get(E[ve]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,V,0)}i.blitFramebuffer(0,0,$,_e,0,0,$,_e,he,i.NEAREST),l===!0&&(Me.length=0,Me.push(i.COLOR_ATTACHMENT0+ve),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Me.push(we),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Me))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),se)for(let ve=0;ve<E.length;ve++){t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ve,i.RENDERBUFFER,Ee.__webglColorRenderbuffer[ve]);let V=n.get(E[ve]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ve,i.TEXTURE_2D,V,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ee.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&l){let E=N.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[E])}}}function We(N){return Math.min(s.maxSamples,N.samples)}function ye(N){let E=n.get(N);return N.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function mt(N){let E=o.render.frame;u.get(N)!==E&&(u.set(N,E),N.update())}function ke(N,E){let $=N.colorSpace,_e=N.format,he=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||$!==Zo&&$!==Ms&&(Mt.getTransfer($)===It?(_e!==Ui||he!==Qn)&&nt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):rt("WebGLTextures: Unsupported texture color space:",$)),E}function et(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(c.width=N.naturalWidth||N.width,c.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(c.width=N.displayWidth,c.height=N.displayHeight):(c.width=N.width,c.height=N.height),c}this.allocateTextureUnit=ne,this.resetTextureUnits=ee,this.getTextureUnits=ie,this.setTextureUnits=j,this.setTexture2D=ue,this.setTexture2DArray=le,this.setTexture3D=pe,this.setTextureCube=de,this.rebindTextures=it,this.setupRenderTarget=gt,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=$e,this.setupDepthRenderbuffer=Ke,this.setupFrameBufferTexture=Z,this.useMultisampledRTT=ye,this.dispose=B}function zM(i,e){function t(n,s=Ms){let r,o=Mt.getTransfer(s);if(n===Qn)return i.UNSIGNED_BYTE;if(n===uc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===fc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Wu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Xu)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Gu)return i.BYTE;if(n===Hu)return i.SHORT;if(n===fo)return i.UNSIGNED_SHORT;if(n===hc)return i.INT;if(n===Di)return i.UNSIGNED_INT;if(n===vi)return i.FLOAT;if(n===Ni)return i.HALF_FLOAT;if(n===qu)return i.ALPHA;if(n===Yu)return i.RGB;if(n===Ui)return i.RGBA;if(n===ms)return i.DEPTH_COMPONENT;if(n===Ss)return i.DEPTH_STENCIL;if(n===dc)return i.RED;if(n===pc)return i.RED_INTEGER;if(n===$s)return i.RG;if(n===mc)return i.RG_INTEGER;if(n===gc)return i.RGBA_INTEGER;if(n===ba||n===wa||n===Ea||n===Ta)if(o===It)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ba)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ea)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ba)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ea)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ta)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===_c||n===xc||n===yc||n===vc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===_c)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===xc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===yc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===vc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Sc||n===Mc||n===bc||n===wc||n===Ec||n===Aa||n===Tc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Sc||n===Mc)return o===It?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===bc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===wc)return r.COMPRESSED_R11_EAC;if(n===Ec)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Aa)return r.COMPRESSED_RG11_EAC;if(n===Tc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Ac||n===Cc||n===Rc||n===Pc||n===Ic||n===Lc||n===Dc||n===Nc||n===Uc||n===Oc||n===Fc||n===Bc||n===kc||n===zc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Ac)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Cc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Rc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Pc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Ic)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Lc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Dc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Nc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Uc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Oc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Fc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Bc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===kc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===zc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Vc||n===Gc||n===Hc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Vc)return o===It?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Gc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Hc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Wc||n===Xc||n===Ca||n===qc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Wc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Xc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ca)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===qc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===fr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var VM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,GM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,_f=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ha(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ji({vertexShader:VM,fragmentShader:GM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new wt(new fa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},xf=class extends Ii{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,m=null,_=typeof XRWebGLBinding<"u",g=new _f,p={},y=t.getContextAttributes(),R=null,S=null,b=[],M=[],x=new Je,w=null,F=null,I=new Zn;I.viewport=new Jt;let T=new Zn;T.viewport=new Jt;let D=[I,T],L=new rc,P=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(q){let ue=b[q];return ue===void 0&&(ue=new so,b[q]=ue),ue.getTargetRaySpace()},this.getControllerGrip=function(q){let ue=b[q];return ue===void 0&&(ue=new so,b[q]=ue),ue.getGripSpace()},this.getHand=function(q){let ue=b[q];return ue===void 0&&(ue=new so,b[q]=ue),ue.getHandSpace()};function H(q){let ue=M.indexOf(q.inputSource);if(ue===-1)return;let le=b[ue];le!==void 0&&(le.update(q.inputSource,q.frame,c||o),le.dispatchEvent({type:q.type,data:q.inputSource}))}function z(){s.removeEventListener("select",H),s.removeEventListener("selectstart",H),s.removeEventListener("selectend",H),s.removeEventListener("squeeze",H),s.removeEventListener("squeezestart",H),s.removeEventListener("squeezeend",H),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",oe);for(let q=0;q<b.length;q++){let ue=M[q];ue!==null&&(M[q]=null,b[q].disconnect(ue))}P=null,B=null,g.reset();for(let q in p)delete p[q];if(e.setRenderTarget(R),d=null,h=null,f=null,s=null,S=null,ne.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(x.width,x.height,!1),F!==null){let q=F.camera;q.fov=F.fov,q.zoom=F.zoom,q.updateProjectionMatrix(),F=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(q){r=q,n.isPresenting===!0&&nt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(q){a=q,n.isPresenting===!0&&nt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(q){c=q},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&_&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(q){if(s=q,s!==null){if(R=e.getRenderTarget(),s.addEventListener("select",H),s.addEventListener("selectstart",H),s.addEventListener("selectend",H),s.addEventListener("squeeze",H),s.addEventListener("squeezestart",H),s.addEventListener("squeezeend",H),s.addEventListener("end",z),s.addEventListener("inputsourceschange",oe),y.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let le=null,pe=null,de=null;y.depth&&(de=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,le=y.stencil?Ss:ms,pe=y.stencil?fr:Di);let Ue={colorFormat:t.RGBA8,depthFormat:de,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Ue),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new ai(h.textureWidth,h.textureHeight,{format:Ui,type:Qn,depthTexture:new xs(h.textureWidth,h.textureHeight,pe,void 0,void 0,void 0,void 0,void 0,void 0,le),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let le={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,le),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new ai(d.framebufferWidth,d.framebufferHeight,{format:Ui,type:Qn,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ne.setContext(s),ne.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function oe(q){for(let ue=0;ue<q.removed.length;ue++){let le=q.removed[ue],pe=M.indexOf(le);pe>=0&&(M[pe]=null,b[pe].disconnect(le))}for(let ue=0;ue<q.added.length;ue++){let le=q.added[ue],pe=M.indexOf(le);if(pe===-1){for(let Ue=0;Ue<b.length;Ue++)if(Ue>=M.length){M.push(le),pe=Ue;break}else if(M[Ue]===null){M[Ue]=le,pe=Ue;break}if(pe===-1)break}let de=b[pe];de&&de.connect(le)}}function Y(q,ue){ue===null?q.matrixWorld.copy(q.matrix):q.matrixWorld.multiplyMatrices(ue.matrixWorld,q.matrix),q.matrixWorldInverse.copy(q.matrixWorld).invert()}this.updateCamera=function(q){if(s===null)return;let ue=q.near,le=q.far;g.texture!==null&&(g.depthNear>0&&(ue=g.depthNear),g.depthFar>0&&(le=g.depthFar)),L.near=T.near=I.near=ue,L.far=T.far=I.far=le,(P!==L.near||B!==L.far)&&(s.updateRenderState({depthNear:L.near,depthFar:L.far}),P=L.near,B=L.far),L.layers.mask=q.layers.mask|6,I.layers.mask=L.layers.mask&-5,T.layers.mask=L.layers.mask&-3;let pe=q.parent,de=L.cameras;Y(L,pe);for(let Ue=0;Ue<de.length;Ue++)Y(de[Ue],pe);L.projectionMatrix.copy(I.projectionMatrix),L.projectionMatrixInverse.copy(I.projectionMatrixInverse),F===null&&q.isPerspectiveCamera&&(F={camera:q,fov:q.fov,zoom:q.zoom}),ee(q,L,pe)};function ee(q,ue,le){le===null?q.matrix.copy(ue.matrixWorld):(q.matrix.copy(le.matrixWorld),q.matrix.invert(),q.matrix.multiply(ue.matrixWorld)),q.matrix.decompose(q.position,q.quaternion,q.scale),q.updateMatrixWorld(!0),q.projectionMatrix.copy(ue.projectionMatrix),q.projectionMatrixInverse.copy(ue.projectionMatrixInverse),q.isPerspectiveCamera&&(q.fov=to*2*Math.atan(1/q.projectionMatrix.elements[5]),q.zoom=1)}this.getCamera=function(){return L},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(q){l=q,h!==null&&(h.fixedFoveation=q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(L)},this.getCameraTexture=function(q){return p[q]};let ie=null;function j(q,ue){if(u=ue.getViewerPose(c||o),m=ue,u!==null){let le=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let pe=!1;le.length!==L.cameras.length&&(L.cameras.length=0,pe=!0);for(let De=0;De<le.length;De++){let Qe=le[De],tt=null;if(d!==null)tt=d.getViewport(Qe);else{let Bt=f.getViewSubImage(h,Qe);tt=Bt.viewport,De===0&&(e.setRenderTargetTextures(S,Bt.colorTexture,Bt.depthStencilTexture),e.setRenderTarget(S))}let Be=D[De];Be===void 0&&(Be=new Zn,Be.layers.enable(De),Be.viewport=new Jt,D[De]=Be),Be.matrix.fromArray(Qe.transform.matrix),Be.matrix.decompose(Be.position,Be.quaternion,Be.scale),Be.projectionMatrix.fromArray(Qe.projectionMatrix),Be.projectionMatrixInverse.copy(Be.projectionMatrix).invert(),Be.viewport.set(tt.x,tt.y,tt.width,tt.height),De===0&&(L.matrix.copy(Be.matrix),L.matrix.decompose(L.position,L.quaternion,L.scale)),pe===!0&&L.cameras.push(Be)}let de=s.enabledFeatures;if(de&&de.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){f=n.getBinding();let De=f.getDepthInformation(le[0]);De&&De.isValid&&De.texture&&g.init(De,s.renderState)}if(de&&de.includes("camera-access")&&_){e.state.unbindTexture(),f=n.getBinding();for(let De=0;De<le.length;De++){let Qe=le[De].camera;if(Qe){let tt=p[Qe];tt||(tt=new ha,p[Qe]=tt);let Be=f.getCameraImage(Qe);tt.sourceTexture=Be}}}}for(let le=0;le<b.length;le++){let pe=M[le],de=b[le];pe!==null&&de!==void 0&&de.update(pe,ue,c||o)}ie&&ie(q,ue),ue.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ue}),m=null}let ne=new xm;ne.setAnimationLoop(j),this.setAnimationLoop=function(q){ie=q},this.dispose=function(){}}},HM=new Et,Cm=new ht;Cm.set(-1,0,0,0,1,0,0,0,1);function WM(i,e){function t(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,rf(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,y,R,S){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),f(g,p)):p.isMeshPhongMaterial?(r(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),h(g,p),p.isMeshPhysicalMaterial&&d(g,p,S)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),_(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,y,R):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,t(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===On&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,t(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===On&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,t(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,t(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let y=e.get(p),R=y.envMap,S=y.envMapRotation;R&&(g.envMap.value=R,g.envMapRotation.value.setFromMatrix4(HM.makeRotationFromEuler(S)).transpose(),R.isCubeTexture&&R.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Cm),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,y,R){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*y,g.scale.value=R*.5,p.map&&(g.map.value=p.map,t(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function f(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function h(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function d(g,p,y){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===On&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function _(g,p){let y=e.get(p).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function XM(i,e,t,n){let s={},r={};function o(y,R){let S=R.program;n.uniformBlockBinding(y,S,s[y.id])}function a(y,R){let S=s[y.id];S===void 0&&(m(y),S=l(y),s[y.id]=S,y.addEventListener("dispose",g));let b=R.program;n.updateUBOMapping(y,b);let M=e.render.frame;r[y.id]!==M&&(c(y),r[y.id]=M)}function l(y){let R=i.createBuffer(),S=y.__size,b=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,R),i.bufferData(i.UNIFORM_BUFFER,S,b),i.bindBuffer(i.UNIFORM_BUFFER,null),R}function c(y){let R=s[y.id],S=y.uniforms,b=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,R);for(let M=0,x=S.length;M<x;M++){let w=S[M];if(Array.isArray(w))for(let F=0,I=w.length;F<I;F++)u(w[F],M,F,b);else u(w,M,0,b)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(y,R,S,b){if(h(y,R,S,b)===!0){let M=y.__offset,x=y.value;if(Array.isArray(x)){let w=0;for(let F=0;F<x.length;F++){let I=x[F],T=_(I,!0);f(I,y.__data,w),w+=T.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,M,y.__data)}}function f(y,R,S){typeof y=="number"||typeof y=="boolean"?R[S]=y:y.isMatrix3?(R[S]=y.elements[0],R[S+1]=y.elements[1],R[S+2]=y.elements[2],R[S+3]=0,R[S+4]=y.elements[3],R[S+5]=y.elements[4],R[S+6]=y.elements[5],R[S+7]=0,R[S+8]=y.elements[6],R[S+9]=y.elements[7],R[S+10]=y.elements[8],R[S+11]=0):ArrayBuffer.isView(y)?R.set(y.subarray(0,R.length-S),S):y.toArray(R,S)}function h(y,R,S,b){let M=y.value,x=R+"_"+S;if(Array.isArray(M)){b[x]===void 0&&(b[x]=[]);let w=b[x],F=!1;for(let I=0;I<M.length;I++)d(M[I],w,I)===!0&&(F=!0);return F}return d(M,b,x)}function d(y,R,S){if(R[S]===void 0)return typeof y=="number"||typeof y=="boolean"?R[S]=y:ArrayBuffer.isView(y)?R[S]=y.slice():R[S]=y.clone(),!0;{let b=R[S];if(typeof y=="number"||typeof y=="boolean"){if(b!==y)return R[S]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(b.equals(y)===!1)return b.copy(y),!0}}return!1}function m(y){let R=y.uniforms,S=0,b=16;for(let x=0,w=R.length;x<w;x++){let F=Array.isArray(R[x])?R[x]:[R[x]];for(let I=0,T=F.length;I<T;I++){let D=F[I],L=Array.isArray(D.value)?D.value:[D.value],P=Array.isArray(R[x])||Array.isArray(D.value),B=S;for(let z=0,oe=L.length;z<oe;z++){let Y=L[z],ee=_(Y,P),ie=S%b,j=ie%ee.boundary,ne=ie+j;S+=j,ne!==0&&b-ne<ee.storage&&(S+=b-ne),z===0&&(B=S),S+=ee.storage}let H=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new H((S-B)/Float32Array.BYTES_PER_ELEMENT),D.__offset=B}}let M=S%b;return M>0&&(S+=b-M),y.__size=S,y.__cache={},this}function _(y,R){let S={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(S.boundary=4,S.storage=4):y.isVector2?(S.boundary=8,S.storage=8):y.isVector3||y.isColor?(S.boundary=16,S.storage=12):y.isVector4?(S.boundary=16,S.storage=16):y.isMatrix3?(S.boundary=16,S.storage=48):y.isMatrix4?(S.boundary=16,S.storage=64):y.isTexture?nt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(S.boundary=16,S.storage=y.byteLength):nt("WebGLRenderer: Unsupported uniform value type.",y),R===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(y){let R=y.target;R.removeEventListener("dispose",g),i.deleteBuffer(s[R.id]),delete s[R.id],delete r[R.id]}function p(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:p}}var qM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),es=null;function YM(){return es===null&&(es=new or(qM,16,16,$s,Ni),es.name="DFG_LUT",es.minFilter=Nn,es.magFilter=Nn,es.wrapS=Ji,es.wrapT=Ji,es.generateMipmaps=!1,es.needsUpdate=!0),es}var jc=class{constructor(e={}){let{canvas:t=Gp(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=Qn}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let _=d,g=new Set([gc,mc,pc]),p=new Set([Qn,Di,fo,fr,uc,fc]),y=new Uint32Array(4),R=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},b=null,M=null,x=[],w=[],F=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Qi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,T=!1,D=null,L=null,P=null,B=null;this._outputColorSpace=Vn;let H=0,z=0,oe=null,Y=-1,ee=null,ie=new Jt,j=new Jt,ne=null,q=new ct(0),ue=0,le=t.width,pe=t.height,de=1,Ue=null,Ve=null,De=new Jt(0,0,le,pe),Qe=new Jt(0,0,le,pe),tt=!1,Be=new Vs,Bt=new Gl,Dt=!1,en=!1,Z=new Et,me=new G,Se=new Jt,Ke={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},it=!1;function gt(){return oe===null?de:1}let k=n;function Me(C,W){return t.getContext(C,W)}let $e,We,ye,mt,ke,et,N,E,$,_e,he,we,Ee,se,ae,ve,V,ce,re,Ce,be,Ae,Ze;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Xe,!1),t.addEventListener("webglcontextrestored",at,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),k===null){let W="webgl2";if(k=Me(W,C),k===null)throw Me(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ot()}catch(C){throw t.removeEventListener("webglcontextlost",Xe,!1),t.removeEventListener("webglcontextrestored",at,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),rt("WebGLRenderer: "+C.message),C}function ot(){$e=new sS(k),$e.init(),be=new zM(k,$e),We=new Yv(k,$e,e,be),ye=new BM(k,$e),We.reversedDepthBuffer&&h&&ye.buffers.depth.setReversed(!0),L=k.createFramebuffer(),P=k.createFramebuffer(),B=k.createFramebuffer(),mt=new aS(k),ke=new wM,et=new kM(k,$e,ye,ke,We,be,mt),N=new iS(I),E=new cx(k),Ae=new Xv(k,E),$=new rS(k,E,mt,Ae),_e=new cS(k,$,E,Ae,mt),ce=new lS(k,We,et),ae=new $v(ke),he=new bM(I,N,$e,We,Ae,ae),we=new WM(I,ke),Ee=new TM,se=new LM($e),V=new Wv(I,N,ye,_e,m,l),ve=new FM(I,_e,We),Ze=new XM(k,mt,We,ye),re=new qv(k,$e,mt),Ce=new oS(k,$e,mt),mt.programs=he.programs,I.capabilities=We,I.extensions=$e,I.properties=ke,I.renderLists=Ee,I.shadowMap=ve,I.state=ye,I.info=mt}_!==Qn&&(F=new uS(_,t.width,t.height,a,s,r));let ge=new xf(I,k);this.xr=ge,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let C=$e.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=$e.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return de},this.setPixelRatio=function(C){C!==void 0&&(de=C,this.setSize(le,pe,!1))},this.getSize=function(C){return C.set(le,pe)},this.setSize=function(C,W,te=!0){if(ge.isPresenting){nt("WebGLRenderer: Can't change size while VR device is presenting.");return}le=C,pe=W,t.width=Math.floor(C*de),t.height=Math.floor(W*de),te===!0&&(t.style.width=C+"px",t.style.height=W+"px"),F!==null&&F.setSize(t.width,t.height),this.setViewport(0,0,C,W)},this.getDrawingBufferSize=function(C){return C.set(le*de,pe*de).floor()},this.setDrawingBufferSize=function(C,W,te){le=C,pe=W,de=te,t.width=Math.floor(C*te),t.height=Math.floor(W*te),this.setViewport(0,0,C,W)},this.setEffects=function(C){if(_===Qn){rt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let W=0;W<C.length;W++)if(C[W].isOutputPass===!0){nt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(ie)},this.getViewport=function(C){return C.copy(De)},this.setViewport=function(C,W,te,J){C.isVector4?De.set(C.x,C.y,C.z,C.w):De.set(C,W,te,J),ye.viewport(ie.copy(De).multiplyScalar(gt()).round())},this.getScissor=function(C){return C.copy(Qe)},this.setScissor=function(C,W,te,J){C.isVector4?Qe.set(C.x,C.y,C.z,C.w):Qe.set(C,W,te,J),ye.scissor(j.copy(Qe).multiplyScalar(gt()).round())},this.getScissorTest=function(){return tt},this.setScissorTest=function(C){ye.setScissorTest(tt=C)},this.setOpaqueSort=function(C){Ue=C},this.setTransparentSort=function(C){Ve=C},this.getClearColor=function(C){return C.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(C=!0,W=!0,te=!0){let J=0;if(C){let K=!1;if(oe!==null){let Re=oe.texture.format;K=g.has(Re)}if(K){let Re=oe.texture.type,Le=p.has(Re),Pe=V.getClearColor(),Ne=V.getClearAlpha(),Ye=Pe.r,lt=Pe.g,_t=Pe.b;Le?(y[0]=Ye,y[1]=lt,y[2]=_t,y[3]=Ne,k.clearBufferuiv(k.COLOR,0,y)):(R[0]=Ye,R[1]=lt,R[2]=_t,R[3]=Ne,k.clearBufferiv(k.COLOR,0,R))}else J|=k.COLOR_BUFFER_BIT}W&&(J|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(J|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&k.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),D=C},this.dispose=function(){t.removeEventListener("webglcontextlost",Xe,!1),t.removeEventListener("webglcontextrestored",at,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),V.dispose(),Ee.dispose(),se.dispose(),et.dispose(),ke.dispose(),N.dispose(),_e.dispose(),$.dispose(),Ae.dispose(),Ze.dispose(),he.dispose(),ge.dispose(),ge.removeEventListener("sessionstart",qa),ge.removeEventListener("sessionend",Vi),ss.stop()};function Xe(C){C.preventDefault(),jo("WebGLRenderer: Context Lost."),T=!0}function at(){jo("WebGLRenderer: Context Restored."),T=!1;let C=mt.autoReset,W=ve.enabled,te=ve.autoUpdate,J=ve.needsUpdate,K=ve.type;ot(),mt.autoReset=C,ve.enabled=W,ve.autoUpdate=te,ve.needsUpdate=J,ve.type=K}function Ie(C){rt("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function ft(C){let W=C.target;W.removeEventListener("dispose",ft),Gt(W)}function Gt(C){Hn(C),ke.remove(C)}function Hn(C){let W=ke.get(C).programs;W!==void 0&&(W.forEach(function(te){he.releaseProgram(te)}),C.isShaderMaterial&&he.releaseShaderCache(C))}this.renderBufferDirect=function(C,W,te,J,K,Re){W===null&&(W=Ke);let Le=K.isMesh&&K.matrixWorld.determinantAffine()<0,Pe=Io(C,W,te,J,K);ye.setMaterial(J,Le);let Ne=te.index,Ye=1;if(J.wireframe===!0){if(Ne=$.getWireframeAttribute(te),Ne===void 0)return;Ye=2}let lt=te.drawRange,_t=te.attributes.position,qe=lt.start*Ye,xt=(lt.start+lt.count)*Ye;Re!==null&&(qe=Math.max(qe,Re.start*Ye),xt=Math.min(xt,(Re.start+Re.count)*Ye)),Ne!==null?(qe=Math.max(qe,0),xt=Math.min(xt,Ne.count)):_t!=null&&(qe=Math.max(qe,0),xt=Math.min(xt,_t.count));let jt=xt-qe;if(jt<0||jt===1/0)return;Ae.setup(K,J,Pe,te,Ne);let Nt,Ut=re;if(Ne!==null&&(Nt=E.get(Ne),Ut=Ce,Ut.setIndex(Nt)),K.isMesh)J.wireframe===!0?(ye.setLineWidth(J.wireframeLinewidth*gt()),Ut.setMode(k.LINES)):Ut.setMode(k.TRIANGLES);else if(K.isLine){let xn=J.linewidth;xn===void 0&&(xn=1),ye.setLineWidth(xn*gt()),K.isLineSegments?Ut.setMode(k.LINES):K.isLineLoop?Ut.setMode(k.LINE_LOOP):Ut.setMode(k.LINE_STRIP)}else K.isPoints?Ut.setMode(k.POINTS):K.isSprite&&Ut.setMode(k.TRIANGLES);if(K.isBatchedMesh)if($e.get("WEBGL_multi_draw"))Ut.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let xn=K._multiDrawStarts,Ge=K._multiDrawCounts,hn=K._multiDrawCount,St=Ne?E.get(Ne).bytesPerElement:1,os=ke.get(J).currentProgram.getUniforms();for(let un=0;un<hn;un++)os.setValue(k,"_gl_DrawID",un),Ut.render(xn[un]/St,Ge[un])}else if(K.isInstancedMesh)Ut.renderInstances(qe,jt,K.count);else if(te.isInstancedBufferGeometry){let xn=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,Ge=Math.min(te.instanceCount,xn);Ut.renderInstances(qe,jt,Ge)}else Ut.render(qe,jt)};function Co(C,W,te,J){D!==null&&C.isNodeMaterial&&D.setObject(J,C),Dt===!0&&ae.setState(C,te,!1),C.transparent===!0&&C.side===yi&&C.forceSinglePass===!1?(C.side=On,C.needsUpdate=!0,Gi(C,W,J),C.side=Ys,C.needsUpdate=!0,Gi(C,W,J),C.side=yi):Gi(C,W,J)}this.compile=function(C,W,te=null){te===null&&(te=C),D!==null&&D.renderStart(C,W,te),M=se.get(te),M.init(W),w.push(M),te.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(M.pushLight(K),K.castShadow&&M.pushShadow(K))}),C!==te&&C.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(M.pushLight(K),K.castShadow&&M.pushShadow(K))}),M.setupLights(),D!==null&&D.updateLights(M.state.lightsArray),en=this.localClippingEnabled,Dt=ae.init(this.clippingPlanes,en),Dt===!0&&ae.setGlobalState(this.clippingPlanes,W),D!==null&&ve.render(M.state.shadowsArray,te,W);let J=new Set;return C.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Re=K.material;if(Re)if(Array.isArray(Re))for(let Le=0;Le<Re.length;Le++){let Pe=Re[Le];Co(Pe,te,W,K),J.add(Pe)}else Co(Re,te,W,K),J.add(Re)}),M=w.pop(),D!==null&&D.renderEnd(),J},this.compileAsync=function(C,W,te=null){let J=this.compile(C,W,te);return new Promise(K=>{function Re(){if(J.forEach(function(Le){let Ne=ke.get(Le).currentProgram;(Ne===void 0||Ne.isReady())&&J.delete(Le)}),J.size===0){K(C);return}setTimeout(Re,10)}$e.get("KHR_parallel_shader_compile")!==null?Re():setTimeout(Re,10)})};let Sr=null;function zh(C){Sr&&Sr(C)}function qa(){ss.stop()}function Vi(){ss.start()}let ss=new xm;ss.setAnimationLoop(zh),typeof self<"u"&&ss.setContext(self),this.setAnimationLoop=function(C){Sr=C,ge.setAnimationLoop(C),C===null?ss.stop():ss.start()},ge.addEventListener("sessionstart",qa),ge.addEventListener("sessionend",Vi),this.render=function(C,W){if(W!==void 0&&W.isCamera!==!0){rt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(T===!0)return;D!==null&&D.renderStart(C,W);let te=ge.enabled===!0&&ge.isPresenting===!0,J=F!==null&&(oe===null||te)&&F.begin(I,oe);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),ge.enabled===!0&&ge.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(ge.cameraAutoUpdate===!0&&ge.updateCamera(W),W=ge.getCamera()),C.isScene===!0&&C.onBeforeRender(I,C,W,oe),M=se.get(C,w.length),M.init(W),M.state.textureUnits=et.getTextureUnits(),w.push(M),Z.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?Bt.setFromArrayCamera(W):Be.setFromProjectionMatrix(Z,mi,W.reversedDepth),en=this.localClippingEnabled,Dt=ae.init(this.clippingPlanes,en),b=Ee.get(C,x.length),b.init(),x.push(b),this.info.render.frame++,ge.enabled===!0&&ge.isPresenting===!0){let Le=I.xr.getDepthSensingMesh();Le!==null&&rs(Le,W,-1/0,I.sortObjects)}rs(C,W,0,I.sortObjects),b.finish(),D!==null&&D.updateLights(M.state.lightsArray),I.sortObjects===!0&&b.sort(Ue,Ve),it=ge.enabled===!1||ge.isPresenting===!1||ge.hasDepthSensing()===!1,it&&V.addToRenderList(b,C),this.info.autoReset===!0&&this.info.reset(),Dt===!0&&ae.beginShadows();let K=M.state.shadowsArray;if(ve.render(K,C,W),Dt===!0&&ae.endShadows(),(J&&F.hasRenderPass())===!1){let Le=b.opaque,Pe=b.transmissive;if(M.setupLights(),W.isArrayCamera){let Ne=W.cameras;if(Pe.length>0)for(let Ye=0,lt=Ne.length;Ye<lt;Ye++){let _t=Ne[Ye];Ei(Le,Pe,C,_t)}it&&V.render(C);for(let Ye=0,lt=Ne.length;Ye<lt;Ye++){let _t=Ne[Ye];Ro(b,C,_t,_t.viewport)}}else Pe.length>0&&Ei(Le,Pe,C,W),it&&V.render(C),Ro(b,C,W)}oe!==null&&z===0&&(et.updateMultisampleRenderTarget(oe),et.updateRenderTargetMipmap(oe)),J&&F.end(I),C.isScene===!0&&C.onAfterRender(I,C,W),Ae.resetDefaultState(),Y=-1,ee=null,w.pop(),w.length>0?(M=w[w.length-1],et.setTextureUnits(M.state.textureUnits),Dt===!0&&ae.setGlobalState(I.clippingPlanes,M.state.camera)):M=null,x.pop(),x.length>0?b=x[x.length-1]:b=null,D!==null&&D.renderEnd()};function rs(C,W,te,J){if(C.visible===!1)return;if(C.layers.test(W.layers)){if(C.isGroup)te=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(W);else if(C.isLight)M.pushLight(C),C.castShadow&&M.pushShadow(C);else if(C.isSprite){let Le=W.isArrayCamera?Bt:Be;if(!C.frustumCulled||C.intersectsFrustum(Le)){J&&Se.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Z);let Pe=_e.update(C),Ne=C.material;Ne.visible&&b.push(C,Pe,Ne,te,Se.z,null,W)}}else if(C.isMesh||C.isLine||C.isPoints){let Le=W.isArrayCamera?Bt:Be;if(!C.frustumCulled||C.intersectsFrustum(Le)){let Pe=_e.update(C),Ne=C.material;if(J&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),Se.copy(C.boundingSphere.center)):(Pe.boundingSphere===null&&Pe.computeBoundingSphere(),Se.copy(Pe.boundingSphere.center)),Se.applyMatrix4(C.matrixWorld).applyMatrix4(Z)),Array.isArray(Ne)){let Ye=Pe.groups;for(let lt=0,_t=Ye.length;lt<_t;lt++){let qe=Ye[lt],xt=Ne[qe.materialIndex];xt&&xt.visible&&b.push(C,Pe,xt,te,Se.z,qe,W)}}else Ne.visible&&b.push(C,Pe,Ne,te,Se.z,null,W)}}}let Re=C.children;for(let Le=0,Pe=Re.length;Le<Pe;Le++)rs(Re[Le],W,te,J)}function Ro(C,W,te,J){let{opaque:K,transmissive:Re,transparent:Le}=C;M.setupLightsView(te),Dt===!0&&ae.setGlobalState(I.clippingPlanes,te),J&&ye.viewport(ie.copy(J)),K.length>0&&tn(K,W,te),Re.length>0&&tn(Re,W,te),Le.length>0&&tn(Le,W,te),ye.buffers.depth.setTest(!0),ye.buffers.depth.setMask(!0),ye.buffers.color.setMask(!0),ye.setPolygonOffset(!1)}function Ei(C,W,te,J){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[J.id]===void 0){let qe=$e.has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[J.id]=new ai(1,1,{generateMipmaps:!0,type:qe?Ni:Qn,minFilter:vs,samples:Math.max(4,We.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Mt.workingColorSpace})}let Re=M.state.transmissionRenderTarget[J.id],Le=J.viewport||ie;Re.setSize(Le.z*I.transmissionResolutionScale,Le.w*I.transmissionResolutionScale);let Pe=I.getRenderTarget(),Ne=I.getActiveCubeFace(),Ye=I.getActiveMipmapLevel();I.setRenderTarget(Re),I.getClearColor(q),ue=I.getClearAlpha(),ue<1&&I.setClearColor(16777215,.5),I.clear(),it&&V.render(te);let lt=I.toneMapping;I.toneMapping=Qi;let _t=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),M.setupLightsView(J),Dt===!0&&ae.setGlobalState(I.clippingPlanes,J),tn(C,te,J),et.updateMultisampleRenderTarget(Re),et.updateRenderTargetMipmap(Re),$e.has("WEBGL_multisampled_render_to_texture")===!1){let qe=!1;for(let xt=0,jt=W.length;xt<jt;xt++){let Nt=W[xt],{object:Ut,geometry:xn,material:Ge,group:hn}=Nt;if(Ge.side===yi&&Ut.layers.test(J.layers)){let St=Ge.side;Ge.side=On,Ge.needsUpdate=!0,an(Ut,te,J,xn,Ge,hn),Ge.side=St,Ge.needsUpdate=!0,qe=!0}}qe===!0&&(et.updateMultisampleRenderTarget(Re),et.updateRenderTargetMipmap(Re))}I.setRenderTarget(Pe,Ne,Ye),I.setClearColor(q,ue),_t!==void 0&&(J.viewport=_t),I.toneMapping=lt}function tn(C,W,te){let J=W.isScene===!0?W.overrideMaterial:null;for(let K=0,Re=C.length;K<Re;K++){let Le=C[K],{object:Pe,geometry:Ne,group:Ye}=Le,lt=Le.material;lt.allowOverride===!0&&J!==null&&(lt=J),Pe.layers.test(te.layers)&&an(Pe,W,te,Ne,lt,Ye)}}function an(C,W,te,J,K,Re){D!==null&&K.isNodeMaterial&&D.setObject(C,K),C.onBeforeRender(I,W,te,J,K,Re),C.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),K.onBeforeRender(I,W,te,J,C,Re),K.transparent===!0&&K.side===yi&&K.forceSinglePass===!1?(K.side=On,K.needsUpdate=!0,I.renderBufferDirect(te,W,J,K,C,Re),K.side=Ys,K.needsUpdate=!0,I.renderBufferDirect(te,W,J,K,C,Re),K.side=yi):I.renderBufferDirect(te,W,J,K,C,Re),C.onAfterRender(I,W,te,J,K,Re)}function ln(C){let W=0;for(let te of C)te.texture!==null&&W++;return W}function Gi(C,W,te){W.isScene!==!0&&(W=Ke);let J=ke.get(C),K=M.state.lights,Re=M.state.shadowsArray,Le=K.state.version,Pe=he.getParameters(C,K.state,Re,W,te,M.state.lightProbeGridArray),Ne=he.getProgramCacheKey(Pe),Ye=J.programs;J.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?W.environment:null,J.fog=W.fog;let lt=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;J.envMap=N.get(C.envMap||J.environment,lt),J.envMapRotation=J.environment!==null&&C.envMap===null?W.environmentRotation:C.envMapRotation,Ye===void 0&&(C.addEventListener("dispose",ft),Ye=new Map,J.programs=Ye,J.programVariants=new Map);let _t=Ye.get(Ne);if(_t!==void 0){if(J.currentProgram===_t&&J.lightsStateVersion===Le)return Po(C,Pe),_t}else Pe.uniforms=he.getUniforms(C),D!==null&&C.isNodeMaterial&&D.build(C,te,Pe),C.onBeforeCompile(Pe,I),_t=he.acquireProgram(Pe,Ne),Ye.set(Ne,_t),J.uniforms=Pe.uniforms;let qe=J.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(qe.clippingPlanes=ae.uniform),Po(C,Pe),J.needsLights=Cs(C),J.lightsStateVersion=Le,J.needsLights&&(qe.ambientLightColor.value=K.state.ambient,qe.lightProbe.value=K.state.probe,qe.sunLights.value=K.state.sun,qe.sunLightShadows.value=K.state.sunShadow,qe.directionalLights.value=K.state.directional,qe.directionalLightShadows.value=K.state.directionalShadow,qe.spotLights.value=K.state.spot,qe.spotLightShadows.value=K.state.spotShadow,qe.rectAreaLights.value=K.state.rectArea,qe.ltc_1.value=K.state.rectAreaLTC1,qe.ltc_2.value=K.state.rectAreaLTC2,qe.pointLights.value=K.state.point,qe.pointLightShadows.value=K.state.pointShadow,qe.hemisphereLights.value=K.state.hemi,qe.sunShadowMatrix.value=K.state.sunShadowMatrix,qe.sunShadowCascade.value=K.state.sunShadowCascade,qe.directionalShadowMatrix.value=K.state.directionalShadowMatrix,qe.spotLightMatrix.value=K.state.spotLightMatrix,qe.spotLightMap.value=K.state.spotLightMap,qe.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=ln(M.state.lightProbeGridArray),J.currentProgram=_t,J.uniformsList=null,_t}function ti(C,W,te,J,K){let Re=ke.get(C),Le=Re.currentProgram.id+","+J+","+K,Pe=Re.programVariants.get(Le);return Pe===void 0?(Pe=Gi(C,W,te),Re.programVariants.set(Le,Pe)):(Re.currentProgram=Pe,Re.uniformsList=null,Re.outputColorSpace=J,Re.toneMapping=K),Pe}function As(C){if(C.uniformsList===null){let W=C.currentProgram.getUniforms();C.uniformsList=po.seqWithValue(W.seq,C.uniforms)}return C.uniformsList}function Po(C,W){let te=ke.get(C);te.outputColorSpace=W.outputColorSpace,te.batching=W.batching,te.batchingColor=W.batchingColor,te.instancing=W.instancing,te.instancingColor=W.instancingColor,te.instancingMorph=W.instancingMorph,te.skinning=W.skinning,te.morphTargets=W.morphTargets,te.morphNormals=W.morphNormals,te.morphColors=W.morphColors,te.morphTargetsCount=W.morphTargetsCount,te.numClippingPlanes=W.numClippingPlanes,te.numIntersection=W.numClipIntersection,te.vertexAlphas=W.vertexAlphas,te.vertexTangents=W.vertexTangents,te.toneMapping=W.toneMapping}function Io(C,W,te,J,K){W.isScene!==!0&&(W=Ke),et.resetTextureUnits();let Re=W.fog,Le=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?W.environment:null,Pe=oe===null?I.outputColorSpace:oe.isXRRenderTarget===!0?oe.texture.colorSpace:Mt.workingColorSpace,Ne=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Ye=N.get(J.envMap||Le,Ne),lt=J.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,_t=!!te.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),qe=!!te.morphAttributes.position,xt=!!te.morphAttributes.normal,jt=!!te.morphAttributes.color,Nt=Qi;J.toneMapped&&(oe===null||oe.isXRRenderTarget===!0)&&(Nt=I.toneMapping);let Ut=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,xn=Ut!==void 0?Ut.length:0,Ge=ke.get(J),hn=M.state.lights;if(Dt===!0&&(en===!0||C!==ee)){let Ot=C===ee&&J.id===Y;ae.setState(J,C,Ot)}let St=!1,os=!1;J.version===Ge.__version?Ge.needsLights&&Ge.lightsStateVersion!==hn.state.version||K.isBatchedMesh&&Ge.batching===!1||!K.isBatchedMesh&&Ge.batching===!0||K.isBatchedMesh&&Ge.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ge.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ge.instancing===!1||!K.isInstancedMesh&&Ge.instancing===!0||K.isSkinnedMesh&&Ge.skinning===!1||!K.isSkinnedMesh&&Ge.skinning===!0||K.isInstancedMesh&&Ge.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ge.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ge.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ge.instancingMorph===!1&&K.morphTexture!==null||Ge.envMap!==Ye||J.fog===!0&&Ge.fog!==Re||Ge.numClippingPlanes!==void 0&&(Ge.numClippingPlanes!==ae.numPlanes||Ge.numIntersection!==ae.numIntersection)||Ge.vertexAlphas!==lt||Ge.vertexTangents!==_t||Ge.morphTargets!==qe||Ge.morphNormals!==xt||Ge.morphColors!==jt||Ge.morphTargetsCount!==xn||Ge.numLightProbeGrids!==ln(M.state.lightProbeGridArray)?St=!0:(Ge.outputColorSpace!==Pe||Ge.toneMapping!==Nt)&&(os=!0):(St=!0,Ge.__version=J.version);let un=Ge.currentProgram;(St===!0||os===!0)&&(un=os===!0?ti(J,W,K,Pe,Nt):Gi(J,W,K),D&&J.isNodeMaterial&&D.onUpdateProgram(J,un,Ge));let wr=!1,Hi=!1,as=!1,dt=un.getUniforms(),nn=Ge.uniforms;if(ye.useProgram(un.program)&&(wr=!0,Hi=!0,as=!0),J.id!==Y&&(Y=J.id,Hi=!0),wr||ee!==C){ye.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),dt.setValue(k,"projectionMatrix",C.projectionMatrix),dt.setValue(k,"viewMatrix",C.matrixWorldInverse);let fn=dt.map.cameraPosition;fn!==void 0&&fn.setValue(k,me.setFromMatrixPosition(C.matrixWorld)),We.logarithmicDepthBuffer&&dt.setValue(k,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&dt.setValue(k,"isOrthographic",C.isOrthographicCamera===!0),ee!==C&&(ee=C,Hi=!0,as=!0)}if(Ge.needsLights&&(hn.state.sunShadowMap.length>0&&dt.setValue(k,"sunShadowMap",hn.state.sunShadowMap,et),hn.state.directionalShadowMap.length>0&&dt.setValue(k,"directionalShadowMap",hn.state.directionalShadowMap,et),hn.state.spotShadowMap.length>0&&dt.setValue(k,"spotShadowMap",hn.state.spotShadowMap,et),hn.state.pointShadowMap.length>0&&dt.setValue(k,"pointShadowMap",hn.state.pointShadowMap,et)),K.isSkinnedMesh){dt.setOptional(k,K,"bindMatrix"),dt.setOptional(k,K,"bindMatrixInverse");let Ot=K.skeleton;Ot&&(Ot.boneTexture===null&&Ot.computeBoneTexture(),dt.setValue(k,"boneTexture",Ot.boneTexture,et))}K.isBatchedMesh&&(dt.setOptional(k,K,"batchingTexture"),dt.setValue(k,"batchingTexture",K._matricesTexture,et),dt.setOptional(k,K,"batchingIdTexture"),dt.setValue(k,"batchingIdTexture",K._indirectTexture,et),dt.setOptional(k,K,"batchingColorTexture"),K._colorsTexture!==null&&dt.setValue(k,"batchingColorTexture",K._colorsTexture,et));let Wn=te.morphAttributes;if((Wn.position!==void 0||Wn.normal!==void 0||Wn.color!==void 0)&&ce.update(K,te,un),(Hi||Ge.receiveShadow!==K.receiveShadow)&&(Ge.receiveShadow=K.receiveShadow,dt.setValue(k,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&W.environment!==null&&(nn.envMapIntensity.value=W.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=YM()),Hi){if(dt.setValue(k,"toneMappingExposure",I.toneMappingExposure),Ge.needsLights&&Mr(nn,as),Re&&J.fog===!0&&we.refreshFogUniforms(nn,Re),we.refreshMaterialUniforms(nn,J,de,pe,M.state.transmissionRenderTarget[C.id]),Ge.needsLights&&Ge.numLightProbeGrids>0){let Ot=S,fn=0;for(let Bn of M.state.lightProbeGridArray)Bn.texture!==null&&(Ot.textures[fn]=Bn.texture,Ot.min[fn]=Bn.boundingBox.min,Ot.max[fn]=Bn.boundingBox.max,Ot.resolution[fn]=Bn.resolution,fn++);for(let Bn in Ot)Ot[Bn].length=fn;nn.probesSH.value=Ot.textures,nn.probesMin.value=Ot.min,nn.probesMax.value=Ot.max,nn.probesResolution.value=Ot.resolution}po.upload(k,As(Ge),nn,et)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(po.upload(k,As(Ge),nn,et),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&dt.setValue(k,"center",K.center),dt.setValue(k,"modelViewMatrix",K.modelViewMatrix),dt.setValue(k,"normalMatrix",K.normalMatrix),dt.setValue(k,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Ot=J.uniformsGroups;for(let fn=0,Bn=Ot.length;fn<Bn;fn++){let Ya=Ot[fn];Ze.update(Ya,un),Ze.bind(Ya,un)}}return un}function Mr(C,W){C.ambientLightColor.needsUpdate=W,C.lightProbe.needsUpdate=W,C.sunLights.needsUpdate=W,C.sunLightShadows.needsUpdate=W,C.directionalLights.needsUpdate=W,C.directionalLightShadows.needsUpdate=W,C.pointLights.needsUpdate=W,C.pointLightShadows.needsUpdate=W,C.spotLights.needsUpdate=W,C.spotLightShadows.needsUpdate=W,C.rectAreaLights.needsUpdate=W,C.hemisphereLights.needsUpdate=W}function Cs(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return H},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return oe},this.setRenderTargetTextures=function(C,W,te){let J=ke.get(C);J.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),ke.get(C.texture).__webglTexture=W,ke.get(C.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:te,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,W){let te=ke.get(C);te.__webglFramebuffer=W,te.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(C,W=0,te=0){oe=C,H=W,z=te;let J=null,K=!1,Re=!1;if(C){let Pe=ke.get(C);if(Pe.__useDefaultFramebuffer!==void 0){ye.bindFramebuffer(k.FRAMEBUFFER,Pe.__webglFramebuffer),ie.copy(C.viewport),j.copy(C.scissor),ne=C.scissorTest,ye.viewport(ie),ye.scissor(j),ye.setScissorTest(ne),Y=-1;return}else if(Pe.__webglFramebuffer===void 0)et.setupRenderTarget(C);else if(Pe.__hasExternalTextures)et.rebindTextures(C,ke.get(C.texture).__webglTexture,ke.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let lt=C.depthTexture;if(Pe.__boundDepthTexture!==lt){if(lt!==null&&ke.has(lt)&&(C.width!==lt.image.width||C.height!==lt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");et.setupDepthRenderbuffer(C)}}let Ne=C.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Re=!0);let Ye=ke.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Ye[W])?J=Ye[W][te]:J=Ye[W],K=!0):C.samples>0&&et.useMultisampledRTT(C)===!1?J=ke.get(C).__webglMultisampledFramebuffer:Array.isArray(Ye)?J=Ye[te]:J=Ye,ie.copy(C.viewport),j.copy(C.scissor),ne=C.scissorTest}else ie.copy(De).multiplyScalar(de).floor(),j.copy(Qe).multiplyScalar(de).floor(),ne=tt;if(te!==0&&(J=L),ye.bindFramebuffer(k.FRAMEBUFFER,J)&&ye.drawBuffers(C,J),ye.viewport(ie),ye.scissor(j),ye.setScissorTest(ne),K){let Pe=ke.get(C.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+W,Pe.__webglTexture,te)}else if(Re){let Pe=W;for(let Ne=0;Ne<C.textures.length;Ne++){let Ye=ke.get(C.textures[Ne]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ne,Ye.__webglTexture,te,Pe)}}else if(C!==null&&te!==0){let Pe=ke.get(C.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Pe.__webglTexture,te)}Y=-1};function br(C){let W=ke.get(C);return(W.__readFormat!==C.format||W.__readType!==C.type)&&(W.__readFormat=C.format,W.__readType=C.type,W.__formatReadable=We.textureFormatReadable(C.format),W.__typeReadable=We.textureTypeReadable(C.type)),W}this.readRenderTargetPixels=function(C,W,te,J,K,Re,Le,Pe=0){if(!(C&&C.isWebGLRenderTarget)){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=ke.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){ye.bindFramebuffer(k.FRAMEBUFFER,Ne);try{let Ye=C.textures[Pe],lt=Ye.format,_t=Ye.type;C.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Pe);let qe=br(Ye);if(qe.__formatReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(qe.__typeReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=C.width-J&&te>=0&&te<=C.height-K&&k.readPixels(W,te,J,K,be.convert(lt),be.convert(_t),Re)}finally{let Ye=oe!==null?ke.get(oe).__webglFramebuffer:null;ye.bindFramebuffer(k.FRAMEBUFFER,Ye)}}},this.readRenderTargetPixelsAsync=async function(C,W,te,J,K,Re,Le,Pe=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=ke.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(W>=0&&W<=C.width-J&&te>=0&&te<=C.height-K){ye.bindFramebuffer(k.FRAMEBUFFER,Ne);let Ye=C.textures[Pe],lt=Ye.format,_t=Ye.type;C.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Pe);let qe=br(Ye);if(qe.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(qe.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xt=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,xt),k.bufferData(k.PIXEL_PACK_BUFFER,Re.byteLength,k.STREAM_READ),k.readPixels(W,te,J,K,be.convert(lt),be.convert(_t),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let jt=oe!==null?ke.get(oe).__webglFramebuffer:null;ye.bindFramebuffer(k.FRAMEBUFFER,jt);let Nt=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Wp(k,Nt,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,xt),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Re),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(xt),k.deleteSync(Nt),Re}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,W=null,te=0){let J=Math.pow(2,-te),K=Math.floor(C.image.width*J),Re=Math.floor(C.image.height*J),Le=W!==null?W.x:0,Pe=W!==null?W.y:0;et.setTexture2D(C,0),k.copyTexSubImage2D(k.TEXTURE_2D,te,0,0,Le,Pe,K,Re),ye.unbindTexture()},this.copyTextureToTexture=function(C,W,te=null,J=null,K=0,Re=0){let Le,Pe,Ne,Ye,lt,_t,qe,xt,jt,Nt=C.isCompressedTexture?C.mipmaps[Re]:C.image;if(te!==null)Le=te.max.x-te.min.x,Pe=te.max.y-te.min.y,Ne=te.isBox3?te.max.z-te.min.z:1,Ye=te.min.x,lt=te.min.y,_t=te.isBox3?te.min.z:0;else{let dt=Math.pow(2,-K);Le=Math.floor(Nt.width*dt),Pe=Math.floor(Nt.height*dt),C.isDataArrayTexture?Ne=Nt.depth:C.isData3DTexture?Ne=Math.floor(Nt.depth*dt):Ne=1,Ye=0,lt=0,_t=0}J!==null?(qe=J.x,xt=J.y,jt=J.z):(qe=0,xt=0,jt=0);let Ut=be.convert(W.format),xn=be.convert(W.type),Ge;W.isData3DTexture?(et.setTexture3D(W,0),Ge=k.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(et.setTexture2DArray(W,0),Ge=k.TEXTURE_2D_ARRAY):(et.setTexture2D(W,0),Ge=k.TEXTURE_2D),ye.activeTexture(k.TEXTURE0),ye.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,W.flipY),ye.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),ye.pixelStorei(k.UNPACK_ALIGNMENT,W.unpackAlignment);let hn=ye.getParameter(k.UNPACK_ROW_LENGTH),St=ye.getParameter(k.UNPACK_IMAGE_HEIGHT),os=ye.getParameter(k.UNPACK_SKIP_PIXELS),un=ye.getParameter(k.UNPACK_SKIP_ROWS),wr=ye.getParameter(k.UNPACK_SKIP_IMAGES);ye.pixelStorei(k.UNPACK_ROW_LENGTH,Nt.width),ye.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Nt.height),ye.pixelStorei(k.UNPACK_SKIP_PIXELS,Ye),ye.pixelStorei(k.UNPACK_SKIP_ROWS,lt),ye.pixelStorei(k.UNPACK_SKIP_IMAGES,_t);let Hi=C.isDataArrayTexture||C.isData3DTexture,as=W.isDataArrayTexture||W.isData3DTexture;if(C.isDepthTexture){let dt=ke.get(C),nn=ke.get(W),Wn=ke.get(dt.__renderTarget),Ot=ke.get(nn.__renderTarget);ye.bindFramebuffer(k.READ_FRAMEBUFFER,Wn.__webglFramebuffer),ye.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ot.__webglFramebuffer);for(let fn=0;fn<Ne;fn++)Hi&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,ke.get(C).__webglTexture,K,_t+fn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,ke.get(W).__webglTexture,Re,jt+fn)),k.blitFramebuffer(Ye,lt,Ye+Le,lt+Pe,qe,xt,qe+Le,xt+Pe,k.DEPTH_BUFFER_BIT,k.NEAREST);ye.bindFramebuffer(k.READ_FRAMEBUFFER,null),ye.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(K!==0||C.isRenderTargetTexture||ke.has(C)){let dt=ke.get(C),nn=ke.get(W);ye.bindFramebuffer(k.READ_FRAMEBUFFER,P),ye.bindFramebuffer(k.DRAW_FRAMEBUFFER,B);for(let Wn=0;Wn<Ne;Wn++)Hi?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,dt.__webglTexture,K,_t+Wn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,dt.__webglTexture,K),as?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,nn.__webglTexture,Re,jt+Wn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,nn.__webglTexture,Re),K!==0?k.blitFramebuffer(Ye,lt,Ye+Le,lt+Pe,qe,xt,qe+Le,xt+Pe,k.COLOR_BUFFER_BIT,k.NEAREST):as?k.copyTexSubImage3D(Ge,Re,qe,xt,jt+Wn,Ye,lt,Le,Pe):k.copyTexSubImage2D(Ge,Re,qe,xt,Ye,lt,Le,Pe);ye.bindFramebuffer(k.READ_FRAMEBUFFER,null),ye.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else as?C.isDataTexture||C.isData3DTexture?k.texSubImage3D(Ge,Re,qe,xt,jt,Le,Pe,Ne,Ut,xn,Nt.data):W.isCompressedArrayTexture?k.compressedTexSubImage3D(Ge,Re,qe,xt,jt,Le,Pe,Ne,Ut,Nt.data):k.texSubImage3D(Ge,Re,qe,xt,jt,Le,Pe,Ne,Ut,xn,Nt):C.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Re,qe,xt,Le,Pe,Ut,xn,Nt.data):C.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Re,qe,xt,Nt.width,Nt.height,Ut,Nt.data):k.texSubImage2D(k.TEXTURE_2D,Re,qe,xt,Le,Pe,Ut,xn,Nt);ye.pixelStorei(k.UNPACK_ROW_LENGTH,hn),ye.pixelStorei(k.UNPACK_IMAGE_HEIGHT,St),ye.pixelStorei(k.UNPACK_SKIP_PIXELS,os),ye.pixelStorei(k.UNPACK_SKIP_ROWS,un),ye.pixelStorei(k.UNPACK_SKIP_IMAGES,wr),Re===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&k.generateMipmap(Ge),ye.unbindTexture()},this.initRenderTarget=function(C){ke.get(C).__webglFramebuffer===void 0&&et.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?et.setTextureCube(C,0):C.isData3DTexture?et.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?et.setTexture2DArray(C,0):et.setTexture2D(C,0),ye.unbindTexture()},this.resetState=function(){H=0,z=0,oe=null,ye.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Mt._getUnpackColorSpace()}};function Rm(i){let e=i.attributes.position.array,t=i.index.array,n=new Float32Array(e.length),[s,r]=[0,0],o=new Float32Array(0);function a(u,f){[s,r]=[192,Math.max(1,Math.round(192/f))],o.length!==s*r&&(o=new Float32Array(s*r)),o.fill(0);let h=[0,0,0];for(let d=0;d<e.length;d+=3)u(e[d],e[d+1],e[d+2],h),n[d]=h[0]*s,n[d+1]=h[1]*r,n[d+2]=1/h[2];for(let d=0;d<t.length;d+=3)l(3*t[d],3*t[d+1],3*t[d+2])}function l(u,f,h){let[d,m,_,g,p,y]=[n[u],n[u+1],n[f],n[f+1],n[h],n[h+1]],R=(_-d)*(y-m)-(p-d)*(g-m);if(R>=0)return;let S=Math.max(0,Math.ceil(Math.min(d,_,p)-.5)),b=Math.min(s-1,Math.floor(Math.max(d,_,p)-.5)),M=Math.max(0,Math.ceil(Math.min(m,g,y)-.5)),x=Math.min(r-1,Math.floor(Math.max(m,g,y)-.5));for(let w=M;w<=x;w++)for(let F=S;F<=b;F++){let[I,T]=[F+.5,w+.5],D=((I-d)*(y-m)-(p-d)*(T-m))/R,L=((_-d)*(T-m)-(I-d)*(g-m))/R;if(D<0||L<0||D+L>1)continue;let P=n[u+2]+D*(n[f+2]-n[u+2])+L*(n[h+2]-n[u+2]),B=w*s+F;P>o[B]&&(o[B]=P)}}function c(u,f,h,d){let[m,_]=[Math.floor(u*s),Math.floor(f*r)];if(m<0||_<0||m>=s||_>=r)return!1;let g=o[_*s+m];return g>0&&1/g<h-d}return{draw:a,hides:c}}var th="#d81b9a",$M="#0b5c3b",ZM=1.6,Pm=.4,JM=.05,yf=40,nh=10,KM=Array.from({length:yf+1},(i,e)=>[Math.cos(2*Math.PI*e/yf),Math.sin(2*Math.PI*e/yf)]),Js=(i,e,t)=>[i[0]+t*e[0],i[1]+t*e[1],i[2]+t*e[2]],Im=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2];function Lm([i,e,t]){let n=Math.abs(t)<.9?[-e,i,0]:[0,-t,e],s=Math.hypot(...n),[r,o,a]=n.map(l=>l/s);return[[r,o,a],[e*a-t*o,t*r-i*a,i*o-e*r]]}function ih(i,e,t){let n=e.getContext("2d"),s=Rm(t),r=i.size/40,o=new G,[a,l,c,u]=[0,0,1,1],f=i.camera.projectionMatrix.elements,[h,d]=[[],[]];function m(I,T,D,L){let P=f,B=P[3]*I+P[7]*T+P[11]*D+P[15];L[0]=.5+(P[0]*I+P[4]*T+P[8]*D+P[12])/(2*B),L[1]=.5-(P[1]*I+P[5]*T+P[9]*D+P[13])/(2*B),L[2]=B}function _(I){let T=[0,0,0];return m(...I,T),{x:T[0]*a,y:T[1]*l,far:T[2],hidden:s.hides(...T,r)}}function g(I){I.updateMatrixWorld(),f=I.projectionMatrix.clone().multiply(I.matrixWorldInverse).elements,I.getWorldPosition(o),c=Math.min(devicePixelRatio,2),[a,l]=[e.clientWidth,e.clientHeight],u=I.projectionMatrix.elements[5]*l/2,(e.width!==Math.round(a*c)||e.height!==Math.round(l*c))&&([e.width,e.height]=[Math.round(a*c),Math.round(l*c)]),s.draw(m,I.aspect),x()}i.before.push(g);function p(I,T,D){let[L,P]=[new Path2D,new Path2D],B=null;for(let H=1;H<I.length;H++){let z=I[H-1].hidden||I[H].hidden?P:L;z!==B&&z.moveTo(I[H-1].x,I[H-1].y),z.lineTo(I[H].x,I[H].y),B=z}[n.strokeStyle,n.lineWidth]=[T,D],n.stroke(L),n.globalAlpha=Pm,n.setLineDash([4,3]),n.stroke(P),n.setLineDash([]),n.globalAlpha=1}function y({point:I,normal:T}){return Im([o.x-I[0],o.y-I[1],o.z-I[2]],T)<0}function R(I){let T=Number.isFinite(I.radius)?Math.max(I.radius,.05):.05,[D,L]=Lm(I.normal),P=Js(I.point,I.normal,.15),B=y(I),H=KM.map(([z,oe])=>_(Js(Js(P,D,T*z),L,T*oe)));B&&H.forEach(z=>z.hidden=!0),n.beginPath(),H.forEach(({x:z,y:oe})=>n.lineTo(z,oe)),n.globalAlpha=B||_(P).hidden?.12:.3,n.fillStyle=th,n.fill(),n.globalAlpha=1,p(H,th,1.5)}function S(I){let T=Math.hypot(...I.pull);if(T<1e-6)return{..._(I.point),left:!1};let D=I.pull.map(le=>le/T),L=T*ZM,P=i.size/110,B=Math.min(L,6*P),H=Js(I.point,I.normal,.05),z=Array.from({length:nh+1},(le,pe)=>_(Js(H,D,-B-(L-B)*(nh-pe)/nh))),[oe,Y,ee]=[z[0],z[nh],_(H)],ie=u/Y.far;p(z,th,Math.max(2,2*P*ie));let j=2.6*P*ie*(B/(6*P)),ne=Math.atan2(ee.y-Y.y,ee.x-Y.x),q=[o.x-H[0],o.y-H[1],o.z-H[2]],ue=Math.abs(Im(q,D))/Math.hypot(...q);return n.globalAlpha=Y.hidden||y(I)?Pm:1,n.fillStyle=th,n.beginPath(),n.ellipse(Y.x,Y.y,Math.max(j*ue,.1),j,ne,0,2*Math.PI),n.moveTo(Y.x-j*Math.sin(ne),Y.y+j*Math.cos(ne)),n.lineTo(ee.x,ee.y),n.lineTo(Y.x+j*Math.sin(ne),Y.y-j*Math.cos(ne)),n.fill(),n.globalAlpha=1,{...oe,left:oe.x<ee.x}}function b({force:I},{x:T,y:D,left:L}){let P=`${I.toFixed(1)} N`,B=n.measureText(P).width+10,H=L?T-6-B:T+6;n.fillStyle="#ffffffd8",n.fillRect(H,D-22,B,19),n.fillStyle="#a0126f",n.fillText(P,H+5,D-8)}function M(I){let[T,D]=Lm(I.normal),L=i.size/18,P=Js(I.point,I.normal,.25);for(let B of[T,D]){let H=[-1,-.5,0,.5,1].map(z=>_(Js(P,B,z*L)));y(I)&&H.forEach(z=>z.hidden=!0),p(H,$M,2)}}function x(){n.setTransform(c,0,0,c,0,0),n.clearRect(0,0,a,l),n.lineCap="butt",n.font="600 13px system-ui, sans-serif",h.forEach(R),d.forEach(M);let I=h.map(S);h.forEach((T,D)=>b(T,I[D]))}function w(I,T){[h,d]=[I,T.filter(({force:D})=>D>=JM)],x()}return{show:w,shown:()=>h,told:()=>d,hidden:()=>h.map(I=>y(I)||_(Js(I.point,I.normal,.15)).hidden)}}var jM="http://www.w3.org/2000/svg",QM=["#b3261e","#2e7d32","#1652b8"],[Nm,Dm,sh,vf]=[300,62,5,4],eb=32768;function Si(i,e,t,n){let s=document.createElementNS(jM,e);for(let[r,o]of Object.entries(t))s.setAttribute(r,o);return n!==void 0&&(s.textContent=n),i.append(s),s}function rh(i,e){let t=(Nm-Dm)/2;return Dm+t+Math.sign(i)*t*Math.asinh(Math.abs(i)/e)/Math.asinh(eb/e)}function Um(i,e){i.replaceChildren();let t=3*sh+vf,n=e.length*t+vf+20;i.setAttribute("viewBox",`0 0 ${Nm} ${n}`);let s=Math.min(...e[0].noise);for(let r of[-1e4,-1e3,-100,0,100,1e3,1e4]){let o=rh(r,s);Si(i,"line",{x1:o,x2:o,y1:0,y2:n-18,stroke:r?"#e2e2dc":"#555"});let a=Math.abs(r)>=1e3?`${r/1e3}k`:`${r}`;Si(i,"text",{x:o,y:n-6,"font-size":9,"text-anchor":"middle",fill:"#555"},a.replace("-","\u2212"))}e.forEach(({face:r,counts:o,live:a,noise:l,number:c},u)=>{let f=u*t+vf;Si(i,"text",{x:0,y:f+12,"font-size":10,fill:"#333"},`F${r}-S${c}`),o.forEach((h,d)=>{if(!a[d])return;let[m,_,g]=[rh(0,s),rh(l[d],s),rh(h,s)],p=f+d*sh+1;Si(i,"rect",{x:2*m-_,width:2*(_-m),y:p,height:sh-1,fill:"#d9d9d2"});let y={x:Math.min(m,g),width:Math.abs(g-m),y:p,height:sh-1.5,fill:QM[d]};Si(i,"rect",{...y,opacity:Math.abs(h)<l[d]?.35:1})})})}function Om(i,e){i.replaceChildren(...e.map(({face:t,number:n,counts:s,live:r})=>{let o=document.createElement("tr");return[t,n,...s.map((l,c)=>r[c]?Math.round(l):"\u2013")].forEach(l=>o.insertCell().append(String(l))),o}))}var oh=["440154","482475","414487","355f8d","2a788e","21918c","22a884","44bf70","7ad151","bddf26","fde725"].map(i=>new ct(`#${i}`));function tb(i,e){let t=Math.min(.9999,Math.max(0,i))*(oh.length-1);return e.lerpColors(oh[Math.floor(t)],oh[Math.floor(t)+1],t%1)}function nb({content:i,arrays:e}){let t=Cn(e.silicone_normals),n=new Int8Array(t.length/3).fill(-1),s=new Float32Array(n.length).fill(-2),{link_vertex:r,link_source:o}=e;return r.data.forEach((a,l)=>{let c=ib(i,o.data[l]),u=i.faces[c].normal,f=u[0]*t[3*a]+u[1]*t[3*a+1]+u[2]*t[3*a+2];f>Math.max(s[a],.3)&&([n[a],s[a]]=[c,f])}),n}function ib(i,e){let t=0;for(let n=e;n>=i.face_vertices[t];t++)n-=i.face_vertices[t];return t}function Da(i,e,t,n){let[s,r,o]=[e-i.centre_mm[0],t-i.centre_mm[1],n-i.centre_mm[2]];return[i.x,i.y].map((a,l)=>Fm(i.sections?.[l],"plane_mm","length_mm",s*a[0]+r*a[1]+o*a[2]))}function Sf(i,e){return e.map((t,n)=>Fm(i.sections?.[n],"length_mm","plane_mm",t))}function Fm(i,e,t,n){if(!i)return n;let[s,r]=[i[e],i[t]],o=s.findIndex(l=>l>n),a=Math.max(1,o<0?s.length-1:o);return r[a-1]+(n-s[a-1])*(r[a]-r[a-1])/(s[a]-s[a-1])}function Kt(i){if(!Number.isFinite(i))return"\u2013";let e=Math.abs(i);return e>=1e4||e<.001&&e>0?i.toExponential(1):i.toPrecision(3)}function sb({content:i,arrays:e},t){let n=Cn(e.silicone_mm),s=new Float32Array(n.length).fill(-1),r=l=>l.length>1?l[1]-l[0]:1,{x_mm:o,y_mm:a}=i.grid;return t.forEach((l,c)=>{if(l<0)return;let[u,f]=Da(i.faces[l],...n.subarray(3*c,3*c+3));s.set([(u-o[0])/r(o),(f-a[0])/r(a),l],3*c)}),s}var rb=`attribute vec3 chart; varying vec4 onFace;
`,ob=`varying vec4 onFace; uniform sampler2D score; uniform vec3 grid; uniform float mapped;
vec3 mapColour(vec3 plain) {
  if (mapped < 0.5) return plain;
  float face = floor(onFace.z + 0.5);
  vec2 last = grid.xy - 1.0;
  bool judged = face >= 0.0 && abs(onFace.z - face) < 0.01 && abs(onFace.w - onFace.z * onFace.z) < 0.01
    && all(greaterThan(onFace.xy, vec2(-0.5))) && all(lessThan(onFace.xy, last + 0.5));
  vec2 at = clamp(onFace.xy, vec2(0.0), last) + 0.5;
  vec4 found = texture2D(score, vec2(at.x, face * grid.y + at.y) / vec2(grid.x, grid.y * grid.z));
  return judged && found.a > 0.5 ? found.rgb / found.a : vec3(0.58);
}
`;function ab(i,e){i.onBeforeCompile=t=>{Object.assign(t.uniforms,e),t.vertexShader=rb+t.vertexShader.replace("#include <begin_vertex>",`#include <begin_vertex>
onFace = vec4(chart, chart.z * chart.z);`),t.fragmentShader=ob+t.fragmentShader.replace("#include <color_fragment>","diffuseColor.rgb = mapColour(diffuseColor.rgb);")},i.needsUpdate=!0}function ah(i,e,t){let{content:n,arrays:s}=i,r=nb(i),[o,a,l]=[n.grid.x_mm.length,n.grid.y_mm.length,n.faces.length],c=o*a,u=new or(new Uint8Array(4*c*l),o,a*l);u.magFilter=u.minFilter=Nn,u.colorSpace=Vn;let f={score:{value:u},grid:{value:new G(o,a,l)},mapped:{value:0}};e.silicone.front.geometry.setAttribute("chart",new Pn(sb(i,r),3)),ab(e.silicone.front.material,f);let h=null,d={};function m(S){if(d[S.stem])return d[S.stem];let b=Array.from(s[`map_${S.stem}`].data).filter(M=>Number.isFinite(M)&&(!S.log||M>0));return[Math.min(...b),Math.max(...b)]}function _(S){let b=m(S),[M,x]=S.log?b.map(Math.log):b,w=I=>((S.log?Math.log(I):I)-M)/(x-M||1);return{share:I=>S.weak==="high"?1-w(I):w(I),at:I=>{let T=M+I*(x-M);return S.log?Math.exp(T):T}}}function g(S){return h=n.maps.find(b=>b.stem===S)??null,f.mapped.value=h?1:0,h&&p(_(h),s[`map_${S}`].data),t.redraw(),h&&{map:h,at:_(h).at}}function p(S,b){let M=new ct,x={};b.forEach((w,F)=>{let[I,T]=[Math.floor(F/c),F%c],D=4*((I*a+T%a)*o+Math.floor(T/a));u.image.data.fill(0,D,D+4),Number.isFinite(w)&&(tb(S.share(w),M).getRGB(x,Vn),u.image.data.set([x.r,x.g,x.b,1].map(L=>255*L),D))}),u.needsUpdate=!0}return{owner:r,show:g,valueAt:(S,b)=>h&&s[`map_${h.stem}`].data[S*c+b],shown:()=>h,endsOf:m,fix:(S,b)=>d[S]=b}}function lh(i,e){if(i.hidden=!e,!e)return;let t=oh.map(l=>`#${l.getHexString()}`);e.map.weak==="high"&&t.reverse(),i.querySelector(".scale").style.background=`linear-gradient(to right, ${t})`;let n=i.querySelectorAll(".ticks span");n.forEach((l,c)=>{let u=Kt(e.at(c/(n.length-1)));l.textContent!==u&&(l.textContent=u)});let{title:s,unit:r,log:o,force_n:a}=e.map;i.querySelector(".title").textContent=`${s}, ${r} at ${a} N${o?", logarithmic":""}. Dark is weak; grey: not judged.`}var lb=1e-6,[ch,go,hh,uh]=[300,230,46,40];function Bm(i,{objectives:e,trials:t,layouts:n},s){i.setAttribute("viewBox",`0 0 ${ch} ${go}`);let r=n.map((m,_)=>[...m.scores.slice(0,2),_]).filter(m=>!m.includes(null)),o=m=>Math.log(Math.max(m,lb)),a=[0,1].map(m=>{let _=[...t,...r].map(g=>o(g[m]));return[Math.min(..._),Math.max(..._)]}),l=(m,_)=>(o(m)-a[_][0])/(a[_][1]-a[_][0]||1),c=m=>hh+8+l(m,0)*(ch-hh-16),u=m=>go-uh-8-l(m,1)*(go-uh-16),f=(m,_)=>Si(i,"text",{"font-size":9,fill:"#444",..._},m);Si(i,"path",{d:`M${hh} 0V${go-uh}H${ch}`,fill:"none",stroke:"#555"});for(let m of[0,.5,1]){let[_,g]=a.map(([p,y])=>Math.exp(p+m*(y-p)));f(Kt(_),{x:c(_),y:go-uh+12,"text-anchor":"middle"}),f(Kt(g),{x:hh-4,y:u(g)+3,"text-anchor":"end"})}f(e[0],{x:ch,y:go-12,"text-anchor":"end"}),f(e[1],{x:0,y:0,"text-anchor":"end",transform:"translate(9 0) rotate(-90)"});for(let[m,_]of t)Si(i,"circle",{cx:c(m),cy:u(_),r:1.6,fill:"#9a968d"});let h=r.map(([m,_,g])=>{let p=g?Si(i,"circle",{cx:c(m),cy:u(_),r:4.5,stroke:"#1652b8","stroke-width":1.5,class:"choice","data-layout":g}):Si(i,"path",{d:`M${c(m)-4} ${u(_)-4}l8 8m0 -8l-8 8`,stroke:"#1c1c1c","stroke-width":2});return Si(p,"title",{},`${n[g].label}: ${Kt(m)}, ${Kt(_)}`),g&&p.addEventListener("click",()=>s(g)),p});return{mark:m=>h.forEach(_=>_.setAttribute("fill",Number(_.dataset.layout)===m?"#1652b8":"#fff"))}}var km={type:"change"},bf={type:"start"},Vm={type:"end"},fh=new ks,zm=new Dn,cb=Math.cos(70*sf.DEG2RAD),Sn=new G,ei=2*Math.PI,Rt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Mf=1e-6,dh=class extends va{constructor(e,t=null){super(e,t),this.state=Rt.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Xs.ROTATE,MIDDLE:Xs.DOLLY,RIGHT:Xs.PAN},this.touches={ONE:qs.ROTATE,TWO:qs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new cn,this._lastTargetPosition=new G,this._quat=new cn().setFromUnitVectors(e.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new lo,this._sphericalDelta=new lo,this._scale=1,this._panOffset=new G,this._rotateStart=new Je,this._rotateEnd=new Je,this._rotateDelta=new Je,this._panStart=new Je,this._panEnd=new Je,this._panDelta=new Je,this._dollyStart=new Je,this._dollyEnd=new Je,this._dollyDelta=new Je,this._dollyDirection=new G,this._mouse=new Je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=ub.bind(this),this._onPointerDown=hb.bind(this),this._onPointerUp=fb.bind(this),this._onContextMenu=yb.bind(this),this._onMouseWheel=mb.bind(this),this._onKeyDown=gb.bind(this),this._onTouchStart=_b.bind(this),this._onTouchMove=xb.bind(this),this._onMouseDown=db.bind(this),this._onMouseMove=pb.bind(this),this._interceptControlDown=vb.bind(this),this._interceptControlUp=Sb.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Rt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(km),this.update(),this.state=Rt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Sn.copy(t).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Rt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ei:n>Math.PI&&(n-=ei),s<-Math.PI?s+=ei:s>Math.PI&&(s-=ei),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(fh.origin.copy(this.object.position),fh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(fh.direction))<cb?this.object.lookAt(this.target):(zm.setFromNormalAndCoplanarPoint(this.object.up,this.target),fh.intersectPlane(zm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Mf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Mf||this._lastTargetPosition.distanceToSquared(this.target)>Mf?(this.dispatchEvent(km),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ei/60*this.autoRotateSpeed*e:ei/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Sn.setFromMatrixColumn(t,0),Sn.multiplyScalar(-e),this._panOffset.add(Sn)}_panUp(e,t){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(t,1):(Sn.setFromMatrixColumn(t,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(e),this._panOffset.add(Sn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/t.clientHeight),this._rotateUp(ei*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/t.clientHeight),this._rotateUp(ei*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function hb(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function ub(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function fb(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Vm),this.state=Rt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function db(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Xs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Rt.DOLLY;break;case Xs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Rt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Rt.ROTATE}break;case Xs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Rt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Rt.PAN}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(bf)}function pb(i){switch(this.state){case Rt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Rt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Rt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function mb(i){this.enabled===!1||this.enableZoom===!1||this.state!==Rt.NONE||(i.preventDefault(),this.dispatchEvent(bf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Vm))}function gb(i){this.enabled!==!1&&this._handleKeyDown(i)}function _b(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case qs.ROTATE:if(this.enableRotate===!1){this.state=Rt.NONE;break}this._handleTouchStartRotate(i),this.state=Rt.TOUCH_ROTATE;break;case qs.PAN:if(this.enablePan===!1){this.state=Rt.NONE;break}this._handleTouchStartPan(i),this.state=Rt.TOUCH_PAN;break;default:this.state=Rt.NONE}break;case 2:switch(this.touches.TWO){case qs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Rt.TOUCH_DOLLY_PAN;break;case qs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Rt.TOUCH_DOLLY_ROTATE;break;default:this.state=Rt.NONE}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(bf)}function xb(i){switch(this._trackPointer(i),this.state){case Rt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Rt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Rt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Rt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Rt.NONE}}function yb(i){this.enabled!==!1&&i.preventDefault()}function vb(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Sb(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Mb=new G(0,1,0);function ph(i,e,t=!1){let n=new zs({color:i,depthTest:!t,transparent:t}),s=new wt(new xi(e,e,1,10),n),r=new wt(new ua(2.6*e,6*e,14),n),o=new Yt;o.add(s,r),t&&(s.renderOrder=r.renderOrder=5);function a(l,c,u){o.visible=u>1e-6;let f=Math.max(u-6*e,.001);o.position.copy(l),o.quaternion.setFromUnitVectors(Mb,c),s.scale.y=f,s.position.y=f/2,r.scale.setScalar(Math.min(1,u/(6*e))||1),r.position.y=Math.max(u,.001)-3*e*r.scale.x}return{object:o,point:a}}var bb=16250868,mh=.12,wb=40,Eb=250,Tb=.4;function pr(i,e,t="#1c1c1c"){let n=document.createElement("canvas");n.width=n.height=64;let s=n.getContext("2d");s.font="600 44px system-ui, sans-serif",s.textAlign="center",s.textBaseline="middle",s.lineWidth=8,s.strokeStyle="rgba(255,255,255,.85)",s.strokeText(i,32,34),s.fillStyle=t,s.fillText(i,32,34);let r=new ro({map:new la(n),depthTest:!1}),o=new sa(r);return o.scale.setScalar(e),o.renderOrder=10,o}function _o(i,e){return e.position.clone().sub(new G(...i.centre_mm)).dot(new G(...i.normal))>0}function Ab(i,e){let t=new Yt,n=[11740702,3046706,1462968];return["x","y","z"].forEach((s,r)=>{let o=new G().setComponent(r,1),a=ph(n[r],i/90);a.point(e,o,i/4),t.add(a.object);let l=pr(s,i/9,`#${new ct(n[r]).getHexString()}`);l.position.copy(e).addScaledVector(o,i/3.4),t.add(l)}),t}function Cb(){let i=document.createElement("canvas").getContext("webgl2");if(!i)return!1;let e=i.getExtension("WEBGL_debug_renderer_info"),t=e?i.getParameter(e.UNMASKED_RENDERER_WEBGL):"";return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software/i.test(t)}function Rb(i,e,t){let n=t?.6:1,[s,r]=[0,0],o=()=>Math.min(devicePixelRatio,2);function a(){r=0,i.getPixelRatio()!==o()&&e()}function l(){r||(s=0),clearTimeout(r),r=setTimeout(a,Eb)}function c(u){r&&s&&u-s>wb&&(n=Math.max(Tb,.85*n)),s=u;let f=o()*(r?n:1);i.getPixelRatio()!==f&&i.setPixelRatio(f)}return{moved:l,settle:c}}function ns(i,e){let t=Cb(),n=new jc({canvas:i,antialias:!t});n.setClearColor(bb),n.localClippingEnabled=!0;let s=new ea,r=.58*Math.hypot(...e),o=new Zn(30,1,r/50,r*30);o.up.set(0,0,1);let a=new dh(o,i),l=new _a(16777215,2.1);l.position.set(-.5,.65,.8),o.add(l,l.target),l.target.position.set(0,0,-1),s.add(o,new xa(16777215,1.5));let c=new ya(Math.ceil(3*r/20)*20,Math.ceil(3*r/20)*2,12171698,14737626);c.rotation.x=Math.PI/2,c.position.z=-e[2]/2-r*.02;let u=new Yt;u.add(c,Ab(r,new G(-.8*r,-.8*r,c.position.z))),s.add(u);let f=[],h=!1,d=0;function m(b){h=!1,g.settle(b??performance.now()),f.forEach(M=>M(o)),n.render(s,o),d+=1}function _(){h||requestAnimationFrame(m),h=!0}let g=Rb(n,_,t);function p(b=4.3,M=0,x=!1){let w=x?o.position.clone().sub(a.target):new G(.57,-.68,.46),F=Math.max(1,1.25/o.aspect);a.target.set(0,0,M*r),o.position.copy(a.target).addScaledVector(w.normalize(),b*r*F),a.update(),_()}function y({center:b,radius:M}){p(1);let x=Math.min(1,o.aspect)*Math.sin(o.fov*Math.PI/360),w=o.position.clone().sub(a.target).normalize();a.target.copy(b),o.position.copy(b).addScaledVector(w,M/x),a.update()}function R(){let{clientWidth:b,clientHeight:M}=i;!b||!M||(n.setSize(b,M,!1),o.aspect=b/M,o.updateProjectionMatrix(),_())}function S(){g.moved(),_()}return a.addEventListener("change",S),new ResizeObserver(R).observe(i),i.addEventListener("keydown",b=>Pb(b,o,a)),R(),p(),{renderer:n,scene:s,camera:o,controls:a,size:r,draw:m,redraw:_,moved:S,look:p,frame:y,before:f,ground:u,drawn:()=>d}}function Pb(i,e,t){let n=new G().crossVectors(e.position,e.up).normalize(),s={ArrowLeft:[e.up,-mh],ArrowRight:[e.up,mh],ArrowUp:[n,-mh],ArrowDown:[n,mh]},r={"+":.9,"=":.9,"-":1/.9}[i.key],o=e.position.clone().sub(t.target);if(s[i.key])o.applyQuaternion(new cn().setFromAxisAngle(...s[i.key]));else if(r)o.multiplyScalar(r);else return;i.preventDefault(),e.position.copy(t.target).add(o),t.update()}var on={silicone:15521453,core:9086404,board:1733432,chip:2500134,north:13379876,south:2708152,cut:13208155,mould:11060382};function Oi(i,e){let t=new gn;return t.setAttribute("position",new Pn(Cn(i[`${e}_mm`]),3)),t.setAttribute("normal",new Pn(Cn(i[`${e}_normals`]),3)),t.setIndex(new Pn(i[`${e}_triangles`].data,1)),t}function gh(i,e,t,n=on.cut){e.clippingPlanes=t;let s=new zs({color:n,side:On,clippingPlanes:t}),r=new Yt,o=new wt(i,e),a=new wt(i,s);return r.add(o,a),{group:r,front:o,back:a}}function Na(i,e){let t=new _i({color:3159871,clippingPlanes:e});return new _s(new ar(i,35),t)}function Hm(i,e){let[t,n,s,r,o,a,l,c,u]=i;return new Et().set(t,n,s,e[0],r,o,a,e[1],l,c,u,e[2],0,0,0,1)}function Gm(i,e,t){let n=[];if(!i[`${e}_mm`])return n;let s=new Qt({color:t});for(let r=0;r<i[`${e}_mm`].shape[0];r++){let o=pn(i[`${e}_half_mm`],r,3),a=new wt(new jn(...o.map(l=>2*l)),s);Wm(a,Hm(pn(i[`${e}_axes`],r,9),pn(i[`${e}_mm`],r,3))),n.push(a)}return n}function Wm(i,e){e.decompose(i.position,i.quaternion,i.scale),i.userData.rest={position:i.position.clone(),quaternion:i.quaternion.clone()}}function Ib(i){let e=Oi(i,"magnet_half"),t=e.clone().rotateX(Math.PI),[n,s]=["north","south"].map(r=>new Qt({color:on[r]}));return Array.from({length:i.magnet_mm.shape[0]},(r,o)=>{let a=new Yt;return a.add(new wt(e,n),new wt(t,s)),Wm(a,Hm(pn(i.magnet_axes,o,9),pn(i.magnet_mm,o,3))),a})}function _h({content:i,arrays:e},t){let n=new Yt,s=t.size,r=new G(...i.away),o=i.size_mm.reduce((T,D,L)=>T+D*Math.abs(i.away[L]),0),a=Object.fromEntries(i.faces.map(T=>[T.number,new G(...T.normal)])),l=new Dn(new G(0,1,0),0),c=[],u=new Qt({color:on.silicone,transparent:!0}),f=gh(Oi(e,"silicone"),u,c);f.front.renderOrder=2;let h=gh(Oi(e,"core"),new Qt({color:on.core}),c,6258339);h.group.add(Na(h.front.geometry,c));let d=Ib(e),m=Gm(e,"boards",on.board),_=Gm(e,"chips",on.chip);n.add(f.group,h.group,...d,...m,..._);let g=i.faces.map(T=>{let D=pr(String(T.number),s/8),L=a[T.number];return D.position.set(...T.centre_mm).addScaledVector(L,s*.09),D.userData={normal:L,rest:D.position.clone()},n.add(D),D});t.before.push(T=>{for(let D of g){let L=T.position.clone().sub(D.position);D.visible=n.visible&&L.dot(D.userData.normal)>0}});let p=Array.from(e.sensor_face.data),y=Array.from(e.magnet_face.data),R=i.magnets_in_shell?d:m,S=i.magnets_in_shell?[...m,..._]:d,b=T=>{let D=d.includes(T)?y[d.indexOf(T)]:p[(m.includes(T)?m:_).indexOf(T)];return a[D]},M=0;function x(T){M=T;let D=r.clone().multiplyScalar(.95*o*T);f.group.position.copy(D),g.forEach(L=>L.position.copy(L.userData.rest).add(D).addScaledVector(L.userData.normal,.2*s*T));for(let L of R)L.position.copy(w(L)).add(D).addScaledVector(b(L),.2*s*T);for(let L of S)L.position.copy(w(L)).addScaledVector(b(L),.16*s*T);t.redraw()}let w=T=>T.userData.moved??T.userData.rest.position;function F(T,D){c.length=0,T&&(l.normal.set(0,0,0).setComponent("xyz".indexOf(T),T==="y"?1:-1),l.constant=D*i.size_mm["xyz".indexOf(T)]/2,c.push(l)),[f,h].forEach(L=>L.back.visible=c.length>0),[f,h].forEach(L=>L.group.traverse(P=>P.material&&(P.material.needsUpdate=!0))),t.redraw()}function I(T){u.opacity=T,u.depthWrite=T>.95,t.redraw()}return F("",0),{root:n,silicone:f,core:h,faces:g,movers:R,explode:x,clip:F,fade:I,offset:()=>f.group.position,again:()=>x(M)}}function Xm({content:i,arrays:e},t){let n=new Yt,s=[11060382,9745290,12760022,14272928],r=i.mould.map((l,c)=>{let u=l.name==="cast shell",f=new Qt({color:u?on.silicone:l.name.startsWith("core")?on.core:s[c%s.length],side:yi,transparent:!u,opacity:u?1:.9}),h=new wt(Oi(e,`mould_${c}`),f);return h.add(Na(h.geometry,[])),n.add(h),{...l,mesh:h,pull:new G(...l.pull_mm)}});function o(l){for(let{mesh:c,pull:u,begins:f,ends:h}of r){let d=Math.min(1,Math.max(0,(l-f)/(h-f)));c.position.copy(u).multiplyScalar(d)}t.redraw()}function a(){let l=new gi;for(let{mesh:c,pull:u}of r)c.geometry.computeBoundingBox(),l.union(c.geometry.boundingBox).union(c.geometry.boundingBox.clone().translate(u));return l.getBoundingSphere(new Li)}return o(0),n.visible=!1,{root:n,open:o,pieces:r,bounds:a}}var Lb=2500;function Ym(i,{content:e,arrays:t}){let n=p=>i.querySelector(`[data-name="${p}"]`);i.hidden=!1;let s=ns(n("canvas"),e.size_mm),[r]=e.layouts,o=!t.body_mm,a=[["body",on.silicone,.18],["core",on.core,.4]].filter(([p])=>o||t[`${p}_mm`]).map(([p,...y])=>({name:p,...Nb(o?new jn(2,2,2):Oi(t,p),...y,s)})),l=bs(s,()=>Tf()),c=bs(s,()=>Ua(on.chip)),u=bs(s,()=>Ua(on.board)),f=new _s(new gn,new _i({color:14162842,depthTest:!1,transparent:!0}));f.renderOrder=4,s.scene.add(f),e.faces.forEach(p=>Oa(p,s));let h={shown:Math.min(1,e.layouts.length-1),share:1},d=n("front")&&Bm(n("front"),e,p=>g(p,1));function m(){let p=e.layouts[h.shown],y=h.share;a.forEach(S=>S.place(Ef(r[S.name],p[S.name],y))),l.place(wf(r.magnets,p.magnets,p.magnet_from,y)),c.place(wf(r.chips,p.chips,p.sensor_from,y)),u.place(wf(r.boards,p.boards,p.sensor_from,y));let R=p.magnets.flatMap((S,b)=>p.magnet_from[b]<0?[]:[...r.magnets[p.magnet_from[b]].at,...S.at]);f.geometry.setAttribute("position",new kt(R,3)),f.geometry.computeBoundingSphere(),s.redraw()}function _(){let p=e.layouts[h.shown];n("scores").replaceChildren(...e.objectives.map((y,R)=>{let S=document.createElement("tr");return[y,Kt(r.scores[R]),Kt(p.scores[R])].forEach(b=>S.insertCell().append(b)),S})),n("after").textContent=p.label,n("share").setAttribute("aria-valuetext",`${Math.round(100*h.share)} % of the way to ${p.label}`),d?.mark(h.shown)}function g(p,y){Object.assign(h,{shown:p,share:y}),n("layout").value=String(p),n("share").value=String(100*y),_(),m()}return n("layout").append(...e.layouts.slice(1).map((p,y)=>new Option(p.label,y+1))),n("layout").addEventListener("change",()=>g(Number(n("layout").value),h.share)),n("share").addEventListener("input",()=>g(h.shown,Number(n("share").value)/100)),n("opacity").addEventListener("input",()=>a.forEach(p=>p.fade(Number(n("opacity").value)/100))),n("home").addEventListener("click",()=>s.look(4.3)),n("play").addEventListener("click",()=>Db(p=>g(h.shown,p))),g(h.shown,1),{host:i,view:s}}function Db(i){let e=performance.now(),t=matchMedia("(prefers-reduced-motion: reduce)").matches;function n(s){let r=t?1:Math.min(1,Math.max(0,(s-e)/Lb));i(r),r<1&&requestAnimationFrame(n)}requestAnimationFrame(n)}var qm=(i,e,t)=>i.map((n,s)=>n+t*(e[s]-n));function xh(i){let[e,t,n,s,r,o,a,l,c]=i;return new cn().setFromRotationMatrix(new Et().set(e,t,n,0,s,r,o,0,a,l,c,0,0,0,0,1))}function Ef(i,e,t){let n=xh(i.axes).slerp(xh(e.axes),t);return{at:qm(i.at,e.at,t),turn:n,half:qm(i.half,e.half,t)}}function wf(i,e,t,n){let s=(o,a)=>({...o,half:o.half.map(l=>l*a)}),r=i.filter((o,a)=>!t.includes(a));return[...e.map((o,a)=>Ef(t[a]<0?s(o,0):i[t[a]],o,n)),...r.map(o=>Ef(o,s(o,0),n))]}function bs(i,e){let t=[];function n(s){for(;t.length<s.length;)t.push(e()),i.scene.add(t.at(-1));t.forEach((r,o)=>{r.visible=o<s.length&&Math.min(...s[o].half)>1e-4,r.visible&&(r.position.set(...s[o].at),r.quaternion.copy(s[o].turn),r.scale.set(...s[o].half))})}return{place:n}}var Ua=i=>new wt(new jn(2,2,2),new Qt({color:i}));function Tf(){let i=new Yt;for(let[e,t]of[[on.north,.5],[on.south,-.5]]){let n=new wt(new xi(1,1,1,32),new Qt({color:e}));n.rotation.x=Math.PI/2,n.position.z=t,i.add(n)}return i}function Nb(i,e,t,n){let s=new Qt({color:e,transparent:!0,opacity:t,depthWrite:!1}),r=new wt(i,s);r.add(new _s(new ar(i,35),new _i({color:3159871})));let o=bs(n,()=>r);return{place:l=>o.place([l]),fade:l=>{s.opacity=t*2*l,n.redraw()}}}function Oa(i,e){let t=pr(String(i.number),e.size/8);t.position.set(...i.centre_mm).addScaledVector(new G(...i.normal),e.size*.09),e.scene.add(t),e.before.push(n=>t.visible=_o(i,n))}function $m(i,{content:e,arrays:t}){let n=S=>i.querySelector(`[data-name="${S}"]`);i.hidden=!1;let s=ns(n("canvas"),e.size_mm),r=new Qt({color:on.silicone,transparent:!0,opacity:.6,depthWrite:!1}),o=Oi(t,"skin");s.scene.add(new wt(o,r)),e.faces.forEach(S=>Oa(S,s));let a=ih(s,n("overlay"),o),[l,c,u]=["point_mm","normal","pull_n"].map(S=>Cn(t[S])),[f,h]=["radius_mm","halfwidth_n"].map(S=>Cn(t[S])),d=Cn(t.time_s),m={grasp:0,frame:0,playing:0},_=()=>e.grasps[m.grasp].frames,g=(S,b)=>S.subarray(3*b,3*b+3);function p(S,b){Object.assign(m,{grasp:S,frame:b});let M=_()[0]+b,x=t.first.data[M],w=Array.from({length:t.first.data[M+1]-x},(I,T)=>{let[D,L,P]=[l,c,u].map(H=>g(H,x+T)),B=-(P[0]*L[0]+P[1]*L[1]+P[2]*L[2]);return{point:D,normal:L,pull:P,force:B,radius:f[x+T],halfwidth:h[x+T]}});a.show(w,[]),n("grasp").value=String(S),n("time").max=String(_()[1]-1),n("time").value=String(b);let F=w.reduce((I,{force:T})=>I+T,0);n("felt").textContent=`${d[M].toFixed(2)} s: ${w.length} contacts, ${F.toFixed(1)} N in sum`,n("time").setAttribute("aria-valuetext",n("felt").textContent)}function y(){let S=performance.now(),b=d[_()[0]],M=++m.playing;function x(w){if(M!==m.playing)return;let F=m.frame;for(;F<_()[1]-1&&d[_()[0]+F+1]-b<=(w-S)/1e3;)F+=1;F!==m.frame&&p(m.grasp,F),F<_()[1]-1&&requestAnimationFrame(x)}p(m.grasp,0),requestAnimationFrame(x)}let R=()=>m.playing+=1;return n("grasp").append(...e.grasps.map(({name:S},b)=>new Option(S,b))),n("grasp").addEventListener("change",()=>(R(),p(Number(n("grasp").value),0))),n("time").addEventListener("input",()=>(R(),p(m.grasp,Number(n("time").value)))),n("play").addEventListener("click",y),n("home").addEventListener("click",()=>s.look(4.3)),s.draw(),p(0,e.grasps[0].peak),{host:i,view:s}}var Ub=["map","explode","opacity","clip-axis","clip","opening"];function Km(i){let e=!1,t=(s,r)=>{if(!e){e=!0;try{i.filter(o=>o!==s).forEach(r)}finally{e=!1}}};Fb(i);for(let s of i){s.watchers.push(()=>t(s,r=>Zm(s,r))),s.view.controls.addEventListener("change",()=>t(s,r=>Jm(s,r)));for(let r of["input","change"])s.host.addEventListener(r,o=>t(s,a=>Ob(o,a)));s.find("open").addEventListener("click",()=>t(s,r=>r.find("open").click()))}let n=i.reduce((s,r)=>s.view.size>=r.view.size?s:r);t(n,s=>Jm(n,s)),t(i[0],s=>Zm(i[0],s))}function Zm(i,e){let{face:t,place:n,step:s}=i.press.state,r=i.content.faces[t].number,o=e.content.faces.findIndex(f=>f.number===r);if(o<0)return;let[a,l]=i.press.xy(n),c=s?i.press.depths[s-1]:0,u=[0,...e.press.depths].map(f=>Math.abs(f-c));e.choose(o,e.near(o,a,l),u.indexOf(Math.min(...u)))}function Jm(i,e){e.view.controls.target.copy(i.view.controls.target),e.view.camera.position.copy(i.view.camera.position),e.view.controls.update(),e.view.redraw()}function Ob(i,e){let{name:t}=i.target.dataset;if(i.target.type==="radio"){let n=e.host.querySelector(`[type=radio][value="${i.target.value}"]`);if(n.closest("label").hidden)return;n.checked=!0,n.dispatchEvent(new Event(i.type))}else Ub.includes(t)&&(e.find(t).value=i.target.value,e.find(t).dispatchEvent(new Event(i.type)))}function Fb(i){for(let{stem:e}of i[0].content.maps){let t=i.map(r=>r.content.maps.find(o=>o.stem===e)),n=i.map((r,o)=>r.maps.endsOf(t[o])),s=[Math.min(...n.map(([r])=>r)),Math.max(...n.map(([,r])=>r))];i.forEach(r=>r.maps.fix(e,s))}}var yh=Math.sqrt(-2*Math.log(.05)),jm=64,Bb=.15,[kb,zb]=[16777215,1.06],Qm=[1,2,5,10,20,50,100];function Vb(i){let e=new oo(new gn,new _i({color:i,depthTest:!1,transparent:!0}));return e.renderOrder=6,e}function Fa(i,e,t){if(i===null)return{most:NaN,least:NaN,turn:0};let[n,s]=[(i+t)/2,Math.hypot((i-t)/2,e)];return{most:Math.sqrt(n+s),least:Math.sqrt(Math.max(0,n-s)),turn:Math.atan2(2*e,i-t)/2}}function vh({content:i,arrays:e},t,n,s,r){let o=new Yt;o.add(...[kb,r].map(Vb)),o.visible=!1;let a=new ys,l=e.place_xy_mm.shape[0],c=Gb(i,e,n,s.size),u=null;function f(m,_){let{most:g}=n(m,_);o.visible=Number.isFinite(g);let p=`${m} ${_}`;if(!o.visible||u===p&&i.faces[m].flat)return;u=p;let y=new G(...pn(e.place_mm,m*l+_,3)),[R,S,b]=["x","y","normal"].map(M=>new G(...i.faces[m][M]));t.silicone.front.updateWorldMatrix(!0,!1),o.children.forEach((M,x)=>{let w=c*(x?1:zb),F=h(m,_,y,[R,S,b],w);M.geometry.setAttribute("position",new kt(F,3)),M.geometry.computeBoundingSphere()})}function h(m,_,g,[p,y,R],S){let{most:b,least:M,turn:x}=n(m,_),w=[],F=pn(e.place_xy_mm,_,2),I=Sf(i.faces[m],F);for(let T=0;T<=jm;T++){let D=2*Math.PI*T/jm,[L,P]=[S*yh*b*Math.cos(D),S*yh*M*Math.sin(D)],B=[F[0]+L*Math.cos(x)-P*Math.sin(x),F[1]+L*Math.sin(x)+P*Math.cos(x)],H=Sf(i.faces[m],B),z=g.clone().addScaledVector(p,H[0]-I[0]).addScaledVector(y,H[1]-I[1]),oe=i.faces[m].flat?z:d(z,R,2*S*yh*b+1);oe&&w.push(...oe.addScaledVector(R,Bb).toArray())}return w}function d(m,_,g){a.set(m.clone().addScaledVector(_,g).add(t.offset()),_.clone().negate()),a.far=2*g;let[p]=a.intersectObject(t.silicone.front,!1);return p?p.point.sub(t.offset()):null}return{line:o,scale:c,draw:f,hide:()=>o.visible=!1}}function Gb({faces:i},{place_xy_mm:e},t,n){let s=e.shape[0],r=i.flatMap((a,l)=>Array.from({length:s},(c,u)=>yh*t(l,u).most)).filter(Number.isFinite).sort((a,l)=>a-l),o=r[Math.floor(r.length/2)]??n;return Qm.find(a=>a*o>=n/45)??Qm.at(-1)}function eg(i,e,t){let{content:n,arrays:s}=i,{depth_mm:r,shown_steps:o}=n.press,[,a,l]=s.force_n.shape,c=s.sensor_mm.shape[0],u=e.silicone.front.geometry,f=Cn(s.silicone_mm),h=Cn(s.link_mm),d=new Float32Array(s.shape.shape[2]),m=Hb(n.tip,t.size),_=Array.from({length:c},()=>ph(14162842,t.size/130,!0)),[g,p]=[14162842,1842204].map(j=>vh(i,e,z,t,j)),y=new Yt,R=new Yt;R.add(..._.map(j=>j.object)),y.add(m,g.line,p.line),t.scene.add(y,R);let S=Array.from({length:c},(j,ne)=>new G(...pn(s.sensor_mm,ne,3))),b=Array.from({length:c},(j,ne)=>pn(s.sensor_axes,ne,9)),M={face:0,place:0,step:0},x=j=>j?s.force_n.data[(M.face*a+M.place)*l+j-1]:0,w=()=>M.face*a+M.place;function F(j){let ne=x(j);if(!j||!ne)return[];let q=r[j-1],ue=o.length-1,le=o.findIndex(Ve=>r[Ve]>=q);le=le<0?ue:le;let pe=Math.max(0,le-1),de=le===pe?1:Math.max(0,(q-r[o[pe]])/(r[o[le]]-r[o[pe]]));return(le===pe?[[le,1]]:[[pe,1-de],[le,de]]).filter(([,Ve])=>Ve>0).map(([Ve,De])=>[Ve,De*ne/(x(o[Ve]+1)||ne)])}function I(j){d.fill(0);let{data:ne,shape:q,step:ue}=s.shape,[,le,pe]=q;for(let[Ue,Ve]of j){let De=Ve*ue*r[o[Ue]],Qe=(M.face*le+Ue)*pe;for(let tt=0;tt<pe;tt++)d[tt]+=De*ne[(Qe+tt)*a+M.place]}let de=u.attributes.position;de.array.set(f),s.link_vertex.data.forEach((Ue,Ve)=>{let De=d[s.link_source.data[Ve]];for(let Qe=0;Qe<3;Qe++)de.array[3*Ue+Qe]+=De*h[3*Ve+Qe]}),j.length&&T(de.array),de.needsUpdate=!0,u.computeVertexNormals(),u.computeBoundingSphere()}function T(j){let ne=n.tip.radius_mm;if(!ne)return;let{origin:q,axes:ue}=D(),le=q.clone().addScaledVector(ue[2],ne-r[M.step-1]),pe=new G;for(let de=0;de<j.length;de+=3){if(pe.set(j[de]-le.x,j[de+1]-le.y,j[de+2]-le.z),pe.lengthSq()>=ne*ne)continue;let Ue=pe.dot(ue[2]),Ve=-Math.sqrt(ne*ne-pe.lengthSq()+Ue*Ue)-Ue;j[de]+=Ve*ue[2].x,j[de+1]+=Ve*ue[2].y,j[de+2]+=Ve*ue[2].z}}function D(){let j=pn(s.place_axes,w(),9),ne=[0,1,2].map(q=>new G(j[q],j[3+q],j[6+q]).normalize());return{origin:new G(...pn(s.place_mm,w(),3)),axes:ne}}function L(j){e.movers.forEach((ne,q)=>{let ue=new G,le=new G;for(let[De,Qe]of j){let tt=(w()*o.length+De)*e.movers.length+q;ue.addScaledVector(new G(...pn(s.motion_mm,tt,3)),Qe),le.addScaledVector(new G(...pn(s.motion_rad,tt,3)),Qe)}let{position:pe,quaternion:de}=ne.userData.rest;ne.userData.moved=pe.clone().add(ue);let Ue=le.length(),Ve=new cn().setFromAxisAngle(Ue?le.clone().divideScalar(Ue):new G(0,0,1),Ue);ne.quaternion.copy(Ve.multiply(de))}),e.again()}function P(j){return M.step?pn(s.counts,(w()*l+M.step-1)*c+j,3):[0,0,0]}function B(){let j=n.press.noise_counts,ne=s.live.data;return S.map((q,ue)=>({sensor:ue,face:s.sensor_face.data[ue],counts:P(ue),noise:j,live:[0,1,2].map(le=>ne[3*ue+le]>0)}))}function H(){let j=Math.log1p(32e3/Math.min(...n.press.noise_counts));B().forEach(({counts:ne,noise:q,live:ue},le)=>{let pe=new G,de=0;ne.forEach((Ve,De)=>{ue[De]&&(pe.addScaledVector(new G(...b[le].slice(3*De,3*De+3)),Ve),de+=(Ve/q[De])**2)});let Ue=pe.length()?.75*t.size*Math.log1p(Math.sqrt(de))/j:0;_[le].point(S[le],pe.normalize(),de>1?Ue:0)})}function z(j,ne){return Fa(...pn(s.ellipse_mm2,j*a+ne,3))}function oe(j,ne,q){Object.assign(M,{face:j,place:ne,step:q});let ue=F(q);I(ue),L(ue),H(),g.draw(j,ne),p.hide();let{origin:le,axes:pe}=D();m.position.copy(le).addScaledVector(pe[2],-(q?r[q-1]:0)),m.quaternion.setFromUnitVectors(new G(0,0,1),pe[2]),Y()}function Y(){y.position.copy(e.offset()),y.visible=e.root.visible,R.visible=e.root.visible&&e.offset().lengthSq()<1e-6,t.redraw()}function ee(j){j?p.draw(j.face,j.place):p.hide(),t.redraw()}return{state:M,set:oe,hover:ee,xy:j=>Array.from(s.place_xy_mm.data.subarray(2*j,2*j+2)),ringScale:g.scale,signals:B,circle:z,force:()=>x(M.step),depths:r,group:y,places:a,follow:Y}}function Hb({radius_mm:i},e){let t=new Qt({color:7171445,transparent:!0,opacity:.55}),n=new Yt,s=i??e/20;if(i){let o=new wt(new lr(s,40,20),t);o.position.z=s,n.add(o)}let r=new wt(new xi(s*.45,i?s*.45:.1,e/3,24),t);return r.rotation.x=Math.PI/2,r.position.z=(i?s:0)+e/6,n.add(r),n.traverse(o=>o.renderOrder=3),n}var Wb=5,Xb=3e3,tg=0;function ng(i,e){let t=_=>i.querySelector(`[data-name="${_}"]`),{content:n}=e;i.hidden=!1,i.querySelectorAll("[type=radio]").forEach(_=>{_.name=`scene-${tg}`,_.checked=_.value==="object"}),tg+=1;let s=ns(t("canvas"),n.size_mm),r=_h(e,s),o=Xm(e,s);s.scene.add(r.root,o.root);let a=ah(e,r,s),l=eg(e,r,s),c=qb(l.signals()),u=[];function f(){let{face:_,place:g,step:p}=l.state,{x_mm:y,y_mm:R}=n.grid,S=R.length,b=p?l.depths[p-1]:0,M=p?n.press.force_error[p-1]:null,{most:x,least:w}=l.circle(_,g);t("place").textContent=`face ${n.faces[_].number} (${y[Math.floor(g/S)]}, ${R[g%S]}) mm`,t("travel").textContent=`${b.toFixed(2)} mm`,t("force").textContent=`${l.force().toFixed(2)} N`,t("error").textContent=M===null?"":`\xB1 ${(100*M).toFixed(1)} % by the mesh (rms)`,t("bound").textContent=`${Kt(x)} \xD7 ${Kt(w)} mm`,t("ring").textContent=l.ringScale>1?`rings drawn ${l.ringScale} times as large`:"",t("score").textContent=a.shown()?`${Kt(a.valueAt(_,g))} ${a.shown().unit}`:"\u2013";let F=l.signals().map(I=>({...I,number:c[I.sensor]}));Um(t("bars"),F),Om(t("counts"),F),t("depth").setAttribute("aria-valuetext",`${b} mm deep`)}function h(_,g,p){l.set(_,g,p),t("face").value=String(_),t("x").value=String(Math.floor(g/n.grid.y_mm.length)),t("y").value=String(g%n.grid.y_mm.length),t("depth").value=String(p),f(),u.forEach(y=>y(l.state))}Yb(t,n,l),$b(t,{scene:e,object:r,mould:o,maps:a,press:l,choose:h,tell:f,view:s,content:n}),Kb(t,{scene:e,view:s,object:r,maps:a,press:l,choose:h});let d=Sh(l,e,0,0,0);return h(0,d,Math.ceil(l.depths.length/2)),r.fade(Number(t("opacity").value)/100),{host:i,find:t,content:n,view:s,maps:a,press:l,choose:h,near:(_,g,p)=>Sh(l,e,_,g,p),watchers:u}}function qb(i){let e={};return i.map(({face:t})=>e[t]=(e[t]??0)+1)}function Yb(i,e,t){let n=(s,r)=>new Option(r,s);i("face").append(...e.faces.map((s,r)=>n(r,s.number))),i("x").append(...e.grid.x_mm.map((s,r)=>n(r,`${s} mm`))),i("y").append(...e.grid.y_mm.map((s,r)=>n(r,`${s} mm`))),i("map").append(...e.maps.map(({stem:s,title:r})=>n(s,r))),i("depth").max=String(t.depths.length),i("mould-choice").hidden=!e.mould.length}function $b(i,{scene:e,object:t,mould:n,maps:s,press:r,choose:o,tell:a,view:l,content:c}){let u=(m,_,g)=>i(m).addEventListener(_,g),f=m=>Number(i(m).value);u("explode","input",()=>{t.explode(f("explode")/100),r.follow(),l.look(4.3+f("explode")/45,f("explode")/220,!0)}),u("opacity","input",()=>t.fade(f("opacity")/100));let h=()=>t.clip(i("clip-axis").value,f("clip")/100);u("clip-axis","change",h),u("clip","input",h),u("map","change",()=>{let m=s.show(i("map").value);lh(i("legend"),m),m&&(i("opacity").value="100"),t.fade(f("opacity")/100),a()});for(let m of["face","x","y"])u(m,"change",()=>{let[_,g]=[c.grid.x_mm[f("x")],c.grid.y_mm[f("y")]];o(f("face"),Sh(r,e,f("face"),_,g),r.state.step)});u("depth","input",()=>o(r.state.face,r.state.place,f("depth")));let d=()=>n.root.visible?l.frame(n.bounds()):l.look(4.3);u("home","click",d);for(let m of i("scenes").querySelectorAll("input"))m.addEventListener("change",()=>{let _=i("scenes").querySelector("input:checked").value;t.root.visible=_==="object",n.root.visible=_==="mould",i("object-controls").hidden=_!=="object",i("mould-controls").hidden=_!=="mould",l.ground.visible=_==="object",r.follow(),d()});u("opening","input",()=>n.open(f("opening")/100)),u("open","click",()=>Zb(i,n))}function Zb(i,e){let t=performance.now(),n=matchMedia("(prefers-reduced-motion: reduce)").matches;function s(r){let o=n?1:Math.min(1,(r-t)/Xb);i("opening").value=String(100*o),e.open(o),o<1&&requestAnimationFrame(s)}requestAnimationFrame(s)}function Sh(i,{arrays:e},t,n,s){let[r,o]=[0,1/0],{data:a}=e.place_xy_mm;for(let l=0;l<i.places;l++){let c=Math.hypot(a[2*l]-n,a[2*l+1]-s);c<o&&Number.isFinite(e.force_n.data[(t*i.places+l)*i.depths.length])&&([r,o]=[l,c])}return r}function Jb({x_mm:i,y_mm:e},t,n){return[i,e].every((s,r)=>Math.abs(t[r]-n[r])<=(s.length>1?s[1]-s[0]:1)/2+.001)}function Kb(i,{scene:e,view:t,object:n,maps:s,press:r,choose:o}){let a=i("canvas"),l=new ys,{content:c}=e,u=n.silicone.front;function f(d){if(!n.root.visible)return null;let m=a.getBoundingClientRect(),_=new Je((d.clientX-m.left)/m.width*2-1,1-(d.clientY-m.top)/m.height*2);l.setFromCamera(_,t.camera);let g=l.intersectObject(u,!1).find(({point:x})=>u.material.clippingPlanes.every(w=>w.distanceToPoint(x)>=0));if(!g)return null;let p=[g.face.a,g.face.b,g.face.c],y=Math.max(...p.map(x=>s.owner[x]));if(y<0)return null;let R=g.point.clone().sub(n.offset()),[S,b]=Da(c.faces[y],R.x,R.y,R.z),M=Sh(r,e,y,S,b);return{face:y,x:S,y:b,place:M,judged:Jb(c.grid,r.xy(M),[S,b])}}let h=null;a.addEventListener("pointerdown",d=>h=[d.clientX,d.clientY]),a.addEventListener("pointerup",d=>{let m=h&&Math.hypot(d.clientX-h[0],d.clientY-h[1])<Wb;h=null;let _=m&&f(d);_&&o(_.face,_.place,r.state.step||r.depths.length)}),a.addEventListener("pointerleave",()=>{r.hover(null),i("under").textContent=""}),a.addEventListener("pointermove",d=>{if(d.buttons)return;let m=f(d);if(r.hover(m?.judged?m:null),!m)return void(i("under").textContent="");let _=`face ${c.faces[m.face].number} (${m.x.toFixed(1)}, ${m.y.toFixed(1)}) mm`;if(!m.judged)return void(i("under").textContent=`${_}: not judged`);let{most:g,least:p}=r.circle(m.face,m.place),y=s.shown()?`${s.shown().title} ${Kt(s.valueAt(m.face,m.place))} ${s.shown().unit}; `:"";i("under").textContent=`${_}: ${y}\u03C3 ${Kt(g)} \xD7 ${Kt(p)} mm`})}var[Af,ig]=[14162842,16777215];function sg({scene:i,body:e,parts:t,maps:n,view:s,find:r}){let{content:o,arrays:a}=i,l=a.place_xy_mm.shape[0],c=Cn(a.silicone_normals),u=Cn(a.silicone_mm),f=[],h=(b,M)=>f.find(x=>x.face===b&&x.place===M)?.circle??Fa(null),d=[0,1].map(()=>vh(i,e,h,s,Af)),[m,..._]=[ig,Af,Af].map(b=>{let M=new wt(new lr(s.size/(b===ig?45:60),24,16),new Qt({color:b,depthTest:!1,transparent:!0,opacity:.9}));return M.renderOrder=7,M.visible=!1,M});s.scene.add(...d.map(b=>b.line),m,..._);let g=(b,M,x)=>{b.position.fromArray(a.place_mm.data,3*(M*l+x)),b.userData.face=o.faces[M]};s.before.push(b=>[m,..._].forEach(M=>M.visible=!!M.userData.face&&_o(M.userData.face,b)));function p({face:b,place:M},x){let w=new G(...pn(a.place_mm,b*l+M,3)),[F,I]=[1/0,-1];n.owner.forEach((D,L)=>{if(D!==b)return;let P=Math.hypot(u[3*L]-w.x,u[3*L+1]-w.y,u[3*L+2]-w.z);P<F&&([F,I]=[P,L])});let T=I<0?o.faces[b].normal:c.subarray(3*I,3*I+3);return{origin:w,normal:new G(...T),profile:x}}function y(b,{counts:M,noise_counts:x,position_mm2:w,motions:F,skin_mm:I},T,D){f=b.map((L,P)=>({...L,circle:Fa(w[P][0],w[P][1],w[P][3])})),e.bend(f.map(L=>p(L,I))),t.move({face:b[0].face,motions:F}),d.forEach((L,P)=>{L.hide(),L.draw(0,NaN),f[P]&&L.draw(f[P].face,f[P].place)}),_.forEach((L,P)=>f[P]?g(L,f[P].face,f[P].place):L.userData.face=null),R(T,M,x,D),s.redraw()}function R(b,M,x,w){let F=f.map(({circle:{most:T,least:D}},L)=>`(${b[L].map(P=>P.toFixed(1)).join(", ")}) mm to ${Kt(T)} \xD7 ${Kt(D)} mm`),I=f.length>1?"Both presses are read from the same chips at once. ":"";r("pressed").textContent=`${w} N on face ${o.faces[f[0].face].number}: the place is told at ${F.join(" and at ")} (one standard deviation); a ring holds 95 of 100 readings. ${I}The skin is drawn as that of a flat layer. Change of this face's chips in counts, with one standard deviation of noise; bold stands out of it:`,r("press-head").hidden=!1,r("counts").replaceChildren(...Array.from({length:M.length/3},(T,D)=>{let L=document.createElement("tr");return L.append(Object.assign(document.createElement("th"),{textContent:`${D+1}`})),M.slice(3*D,3*D+3).forEach((P,B)=>{let H=L.insertCell();H.textContent=P===null?"\u2013":`${P.toFixed(0).replace("-","\u2212")} \xB1 ${x[B].toFixed(0)}`,H.style.fontWeight=Math.abs(P)>3*x[B]?"700":""}),L}))}function S(){f=[],e.bend([]),t.move(null),d.forEach(b=>b.hide()),_.forEach(b=>b.userData.face=null),r("pressed").textContent="No press.",r("press-head").hidden=!0,r("counts").replaceChildren(),s.redraw()}return{show:y,release:S,markWorst:(b,M)=>g(m,b,M)}}var jb=1e3,Mh=(i,e)=>Object.assign(document.createElement(i),e);function rg({find:i,ask:e,frozen:t,now:n,renew:s,take:r}){let[o,a,l]=[!1,!1,null],c="";async function u(){if(a=!0,!(t||o)){o=!0;try{for(;;){a=!1;let m=await e("state",{design:n().design});if(f(m),m.scene!==n().scene&&s(),!m.work.running&&l&&await h(),!m.refining&&!m.work.running&&!a)break;await new Promise(_=>setTimeout(_,jb))}}catch(m){i("trouble").textContent=m.message}o=!1}}function f({refined:m,work:_}){i("refined").textContent=m,i("improve").disabled=i("confirm").disabled=_.running,i("stop").disabled=!_.running,i("work-command").textContent=_.command,i("work-line").textContent=_.command&&`${_.running?"at work":_.failed?"ended early":"finished"}${_.line?`: ${_.line}`:""}`;let g=JSON.stringify(_.layouts);g!==c&&(c=g,i("layouts").replaceChildren(..._.layouts.map(({label:p,design:y})=>{let R=Mh("li",{textContent:`${p} `});return R.append(Mh("button",{type:"button",textContent:"take",onclick:()=>r(y)})),R})))}async function h(){let{rows:m,channels:_}=await e("confirmed",l);l=null;let g=({page:p,chain:y})=>p===null||y===null?"\u2013":Kt(y/p);i("confirmed").replaceChildren(...m.map(p=>{let y=Mh("tr",{});return y.append(Mh("th",{textContent:p.name})),[p.page,p.chain].forEach(R=>y.insertCell().append(R===null?"\u221E":Kt(R))),y.insertCell().append(g(p)),y})),i("confirmed-head").hidden=!m.length,i("confirmed-note").textContent=m.length&&_==="all"?"The chain reads the chips of all faces, the page those of the pressed face: part of the difference.":""}async function d(m,_){try{let{design:g,force:p}=n();await e(m,{design:g,force_n:p,..._}),i("trouble").textContent="",m==="confirm"&&(l={design:g,force_n:p}),await u()}catch(g){i("trouble").textContent=g.message}}return i("improve").addEventListener("click",()=>d("improve",{seconds:Number(i("seconds").value)})),i("confirm").addEventListener("click",()=>d("confirm",{})),i("stop").addEventListener("click",()=>d("stop",{})),{watch:u}}var og={position:["Error of the place, one standard deviation","mm"],force:["Error of the force, one standard deviation","N"],least:["Least force that is felt","N"]},[Cf,Qb]=["bench","grasp"],Rf=.1,ew=14687012,tw=[.5,2],ag=["size-x","size-y","size-z"],nw=4,iw=300,[ug,sw]=[1,1024],rw=1e9,Mi=i=>JSON.parse(JSON.stringify(i)),Ba=(i,e)=>Object.assign(document.createElement(i),e),lg=(i,e)=>i.textContent!==e&&(i.textContent=e),fg=(i,e)=>i.room_mm[e].map(t=>t.map(n=>Math.max(n-Rf,0))),dg=i=>Math.round(i/Rf)/(1/Rf);async function ow(i,e){let t={method:"POST",body:JSON.stringify(e),headers:{"Content-Type":"application/json"}},n=await fetch(`/${i}`,t).catch(()=>{throw new Error("The server does not answer. Start instobj explore again on the same port: this page keeps the design.")}),s=await n.json();if(!n.ok)throw new Error(s.error??n.statusText);return s}function aw(i){let e=JSON.parse(i.textContent);return async(t,{figure:n,force_n:s,face:r,places:o})=>t==="limits"||t==="range"?e[t]:t==="judge"?e[`judge ${n} ${s}`]:e[`press ${r} ${s}`][o[0]]}async function lw(i){let e=await fetch("/scene",i&&{method:"POST",body:JSON.stringify({design:i}),headers:{"Content-Type":"application/json"}});return Ds(new Uint8Array(await e.arrayBuffer()))}function cw(i){let e=new Map,t=0,n=(a,l)=>{let[c,u]=e.get(a)??[];e.delete(a),c&&(l.error?u(new Error(l.error)):c(l))},s=a=>new Promise((l,c)=>{e.set(++t,[l,c]),a(t)});i.on("change:map",()=>n(i.get("map").request,i.get("map"))),i.on("msg:custom",({number:a,answer:l},c)=>n(a,l??c[0]));let r=(a,l)=>s(c=>{if(a!=="judge")return i.send({number:c,question:a,query:l});for(let[u,f]of Object.entries({...Mi(l),request:c}))i.set(u,f);i.save_changes()});return{ask:r,openScene:async a=>Ds(a?await r("scene",{design:a}):i.get("scene"))}}var hw=()=>{let[i,e]=["answers","scene"].map(t=>document.getElementById(t));return i?{ask:aw(i),openScene:()=>Ds(Ja(e.textContent)),held:!0}:{ask:ow,openScene:lw}};async function Pf(i,e){let{ask:t,openScene:n,held:s}=e?cw(e):hw(),r=Z=>i.querySelector(`[data-name="${Z}"]`),o=await n(),{content:a,arrays:l}=o;i.classList.toggle("frozen",!!s),r("name").textContent=s?`${a.name}, to look at and press`:`${a.name}, explored`,s&&(r("hint").textContent="drag: turn \xB7 shift and click: press"),a.forces_n.forEach(Z=>r("force").append(new Option(`${Z} N`,Z))),Object.keys(a.chips).forEach(Z=>r("chip-part").append(new Option(Z)));let c=Mi(a.design),u=new Option(`as written (${a.as_written})`,"");u.disabled=typeof c.magnets.grade=="string",r("grade").append(u,...a.grades.map(Z=>new Option(Z))),r("disturbed").disabled=!!s,a.silicones.forEach(Z=>r("silicone").append(new Option(Z))),r("of-size").hidden=!a.sizable,r("force").value=String(a.first_force_n);let f=ns(r("canvas"),a.size_mm),h=new Set(f.scene.children),d={design:Mi(a.design),answer:null,broken:[],used:null,pinned:null,chosen:null,presses:[]},m={past:[],future:[]},_=[],g,p,y,R,S;function b(Z){o=Z,{content:a,arrays:l}=Z,f.before.length=0,f.scene.children.filter(me=>!h.has(me)).forEach(me=>{f.scene.remove(me),me.traverse(Se=>Se.geometry?.dispose())}),p=l.place_xy_mm.shape[0],l.map_live={data:new Float32Array(a.faces.length*p).fill(NaN)},a.maps=[{stem:"live",weak:"high",log:!0}],g=pw(o,f),y=ah(o,g,f),R=_w(f,a),S=sg({scene:o,body:g,parts:R,maps:y,view:f,find:r}),d.presses=[],r("accuracy").textContent=a.accuracy,r("level").textContent=a.level,g.fade(Number(r("opacity").value)/100)}b(o);let[M,x,w]=[!1,!1,0],[F,I,T]=[!1,!1,!1],D=Z=>({design:Z,figure:r("figure").value,force_n:Number(r("force").value)});async function L(Z){if(Z&&(w=w||Z),M)return void(x=!0);M=!0;let me=w;w=0;try{d.answer=await P(d.design),r("trouble").textContent="",z(),me&&requestAnimationFrame(()=>requestAnimationFrame(()=>_.push(performance.now()-me))),d.presses.length&&await tt(d.presses),H(),a.scene.endsWith("full")||Bt.watch()}catch(Se){r("trouble").textContent=Se.message}if(M=!1,x)return x=!1,void L();await t("range",{design:d.design}).then(Se=>d.used=Se.range_used,()=>d.used=null),oe()}async function P(Z){let me=await t("judge",D(Z));for(;me.scene!==a.scene;)b(await n(Z)),me=await t("judge",D(Z));return me}let B=Z=>t("limits",{design:Z}).catch(({message:me})=>({broken:[{text:me,magnets:[],sensors:[],faces:[]}]}));async function H(){if(F)return void(I=!0);F=!0;do{I=!1;let Z=new Promise(me=>setTimeout(me,iw));ee(await B(d.design)),await Z}while(I);F=!1}function z(){let{answer:Z,pinned:me}=d,Se=r("difference").checked&&me?.answer.scene===Z.scene,[[Ke,it],gt]=[og[r("figure").value],r("force").value];Z.values.forEach((k,Me)=>{l.map_live.data[Me]=k===null?l.there.data[Me]?rw:NaN:Se?k/me.answer.values[Me]:k}),Object.assign(a.maps[0],Se?{title:"Now over pinned; above 1 is worse",unit:"times"}:{title:Ke,unit:it},{force_n:gt}),y.fix("live",Se?tw:d.ends??=fw(Z.values.filter(k=>k>0))),lh(r("legend"),y.show("live")),R.place(Z.parts),f.moved(),ie(),oe(),De()}function oe(){let{answer:Z,pinned:me,used:Se}=d,Ke=r("figure").value,[it,gt]=[Z.summary[Ke],me?.answer.summary[Ke]],k=og[Ke][1],Me=a.limits[Ke],$e=[[`half of the places are below, ${k}`,it.median,gt?.median],[`95 of 100 places are below, ${k}`,it.percentile_95,gt?.percentile_95],[`worst place${Me?` (for a go ${Me} or less)`:""}, ${k}`,it.worst,gt?.worst],["chips' range in use, %",Se?100*Se:"\u2026",me?.used?100*me.used:""],["magnets; chips",`${Z.magnets}; ${Z.sensors}`,me?`${me.answer.magnets}; ${me.answer.sensors}`:""],["price of both, \u20AC; work by hand, min",Z.price_and_minutes.map(Math.round).join("; "),me?.answer.price_and_minutes.map(Math.round).join("; ")]];r("numbers").rows.length||r("numbers").replaceChildren(...$e.map(([mt])=>uw(mt,["",""]))),$e.forEach(([mt,...ke],et)=>[mt,...ke].forEach((N="",E)=>{lg(r("numbers").rows[et].cells[E],N===null?"\u221E":typeof N=="number"?Kt(N):N)}));let[We,ye]=Y(it.place);lg(r("worst"),`The worst place is on face ${a.faces[it.face].number} at (${We.toFixed(1)}, ${ye.toFixed(1)}) mm, at the white ball.`),S.markWorst(it.face,it.place)}let Y=Z=>Array.from(l.place_xy_mm.data.subarray(2*Z,2*Z+2));function ee({broken:Z}){d.broken=Z;let me=Z.length?Z.map(cg):["All limits of instobj check are kept."];d.answer.beyond&&me.push("A part lies where the quick model knows no motions: it is judged at the nearest place that it knows."),r("limits").replaceChildren(...me.map(Se=>Ba("li",{textContent:Se,className:Z.length?"broken":"kept"}))),ie(),oe()}function ie(){R.paint(d.broken,d.chosen,le(d.design)),f.redraw()}function j(){m.past.push(Mi(d.design)),m.future=[]}function ne(Z,me){m[me].push(d.design),d.design=m[Z].pop(),d.chosen=null,L()}let q=Z=>{j(),Z(d.design),L(performance.now())},ue=Z=>q(()=>{d.design=Mi(Z),d.chosen=null}),le=({magnets:Z})=>!Array.isArray(Z.positions_mm[0][0]);function pe({magnets:Z,sensors:me},Se){return Se==="magnet"?le({magnets:Z})?[Z.positions_mm]:Z.positions_mm:me.positions_mm??=Mi(d.answer.shown.sensors_mm)}function de(Z,me,Se){let Ke=pe(Z,me);return Ke[Ke.length===a.faces.length?Se:(a.faces[Se].number-1)%Ke.length]}let Ue=()=>d.design.magnets.depth_mm??=Mi(d.answer.shown.depth_mm),Ve=({kind:Z,face:me,number:Se})=>de(Mi(d.design),Z,me)[Se];function De(){r("undo").disabled=!m.past.length,r("redo").disabled=!m.future.length;let{chosen:Z,design:me}=d,Se=Z?.kind==="magnet";r("of-magnet").hidden=!Se||!a.magnets_in_shell,r("of-tilt").hidden=!Se||!a.tiltable,r("remove").disabled=!Z,r("part").textContent=Z?`Part: ${Se?"magnet":"chip"} ${Z.number+1} of face ${a.faces[Z.face].number}`:"Part: none chosen, click one",r("alike").textContent=le(me)?"A magnet moves alike on every face; a chip on its face alone.":"Magnets and chips move on their face alone; depth, pole and tilt are alike on every face.",["x","y"].forEach((Ke,it)=>Qe(Ke,Z&&Ve(Z)[it])),Se&&(Qe("depth",(me.magnets.depth_mm??d.answer.shown.depth_mm)[Z.number]),["tilt-x","tilt-y"].forEach((Ke,it)=>Qe(Ke,me.magnets.tilt_deg[Z.number][it])),r("north").value=me.magnets.north[Z.number]),r("grade").value=typeof me.magnets.grade=="string"?me.magnets.grade:"",(r("chip-part").value!==me.sensors.part||!r("range").options.length)&&(r("chip-part").value=me.sensors.part,r("range").replaceChildren(...a.chips[me.sensors.part].map(Ke=>new Option(`\xB1${Ke} mT`,Ke)))),r("range").value=String(me.sensors.range_mt),r("disturbed").checked=me.limits.use!==Cf,Qe("chip-depth",me.sensors.depth_below_core_face_mm),Qe("thickness",me.shell.thickness_mm),r("silicone").value=me.silicone.name,ag.forEach((Ke,it)=>Qe(Ke,me.body.size_mm[it]))}function Qe(Z,me){let Se=r(Z);Se.disabled=me==null,document.activeElement!==Se&&(Se.value=Se.disabled?"":String(me))}async function tt(Z){if(d.presses=Z,r("release").disabled=!Z.length,!Z.length)return S.release();let me=Number(r("force").value),[{face:Se}]=Z,Ke={design:d.design,face:a.faces[Se].number,places:Z.map(({place:gt})=>gt),force_n:me},it=await t("press",Ke);d.presses===Z&&S.show(Z,it,Z.map(({place:gt})=>Y(gt)),me)}let Be=(Z,me,Se)=>r(Z).addEventListener(me,Se),Bt=rg({find:r,ask:t,frozen:!!s,now:()=>({design:d.design,scene:a.scene,force:Number(r("force").value)}),renew:()=>L(),take:ue});e?.on("change:design",()=>JSON.stringify(e.get("design"))!==JSON.stringify(d.design)&&ue(e.get("design")));async function Dt(){d.ends=null,d.pinned&&(d.pinned.answer=await t("judge",D(d.pinned.design))),L()}Be("figure","change",Dt),Be("force","change",Dt),Be("fit","click",()=>{d.ends=null,z()}),Be("difference","change",z),Be("opacity","input",()=>g.fade(Number(r("opacity").value)/100)),Be("undo","click",()=>ne("past","future")),Be("redo","click",()=>ne("future","past")),i.addEventListener("keydown",({key:Z,ctrlKey:me,metaKey:Se,target:Ke})=>(me||Se)&&!Ke.matches("input")&&{z:r("undo"),y:r("redo")}[Z]?.click()),Be("pin","click",()=>{d.pinned=Mi({design:d.design,answer:d.answer,used:d.used}),r("difference").disabled=!1,z()}),Be("save","click",async()=>{try{let Z=await t("save",{design:d.design}),me=Ba("p",{className:"note",textContent:Z.comments_kept?`Saved in ${Z.file}; its comments stayed.`:`Saved in ${Z.file}; the comments of the first file could not be kept.`});r("commands").replaceChildren(me,...Z.commands.map(Se=>Ba("code",{textContent:Se}))),r("trouble").textContent=""}catch(Z){r("trouble").textContent=Z.message}}),["x","y"].forEach((Z,me)=>Be(Z,"change",()=>q(()=>de(d.design,d.chosen.kind,d.chosen.face)[d.chosen.number][me]=Number(r(Z).value)))),Be("depth","change",()=>q(()=>Ue()[d.chosen.number]=Number(r("depth").value))),["tilt-x","tilt-y"].forEach((Z,me)=>Be(Z,"change",()=>q(({magnets:Se})=>Se.tilt_deg[d.chosen.number][me]=Number(r(Z).value)))),Be("north","change",()=>q(({magnets:Z})=>Z.north[d.chosen.number]=r("north").value)),Be("grade","change",()=>q(({magnets:Z})=>Z.grade=r("grade").value||Mi(c.magnets.grade))),Be("chip-part","change",()=>q(({sensors:Z})=>{let me=a.chips[r("chip-part").value];r("range").replaceChildren(),Object.assign(Z,{part:r("chip-part").value,range_mt:me.find(Se=>Se>=Z.range_mt)??me.at(-1)})})),Be("disturbed","change",()=>q(({limits:Z})=>Z.use=r("disturbed").checked?c.limits.use===Cf?Qb:c.limits.use:Cf)),Be("range","change",()=>q(({sensors:Z})=>Z.range_mt=Number(r("range").value))),Be("chip-depth","change",()=>q(({sensors:Z})=>Z.depth_below_core_face_mm=Number(r("chip-depth").value))),Be("thickness","change",()=>q(({shell:Z})=>Z.thickness_mm=Number(r("thickness").value))),Be("silicone","change",()=>q(({silicone:Z})=>Z.name=r("silicone").value)),ag.forEach((Z,me)=>Be(Z,"change",()=>q(Se=>Se.body.size_mm[me]=Number(r(Z).value)))),Be("release","click",()=>tt([]));async function en(Z){let me=JSON.stringify(d.design),Se=Mi(d.design),Ke=pe(Se,Z),it=fg(a,Z),gt=Ke.length===it.length,k=[0,1].map(We=>Math.min(...it.map(ye=>ye[We]))),Me=Ke.map((We,ye)=>dw(We,a.faces[gt?ye:0],gt?it[ye]:k)),$e=(await B(Se)).broken.map(({text:We})=>We);for(Z==="magnet"&&hg(Se.magnets,We=>We.push(Mi(We.at(-1)))),Ke.forEach((We,ye)=>We.push(Me[ye].shift()));;){let We=(await B(Se)).broken.filter(({text:mt})=>!$e.includes(mt));if(JSON.stringify(d.design)!==me)throw new Error("Something else was changed meanwhile: add the part again.");if(!We.length)return q(()=>{d.design=Se});let ye=mt=>!gt||We.some(({faces:ke})=>!ke.length||ke.includes(a.faces[mt].number));if(Ke.forEach((mt,ke)=>ye(ke)&&mt.splice(-1,1,Me[ke].shift())),Ke.some(mt=>!mt.at(-1)))throw new Error(`No room for one more ${Z==="magnet"?"magnet":"chip"} on every face was found: ${cg(We[0])}`)}}for(let Z of["magnet","sensor"])Be(`add-${Z}`,"click",async()=>{T=r(`add-${Z}`).disabled=!0,await en(Z).then(()=>"",({message:me})=>me).then(me=>r("trouble").textContent=me),T=r(`add-${Z}`).disabled=!1});Be("remove","click",()=>q(Z=>{let{kind:me,number:Se}=d.chosen;pe(Z,me).forEach(Ke=>Ke.splice(Se,1)),me==="magnet"&&hg(Z.magnets,Ke=>Ke.splice(Se,1)),d.chosen=null})),xw({stage:i.querySelector(".stage"),canvas:r("canvas"),view:f,now:()=>({body:g,parts:R,content:a,maps:y}),frozen:!!s,choose(Z){d.chosen=Z,ie(),De()},begin:j,move({kind:Z,face:me,number:Se},Ke,it){de(d.design,Z,me)[Se]=Ke,L(it)},press(Z,me,Se,Ke){let it=Array.from({length:p},($e,We)=>l.there.data[Z*p+We]?Math.hypot(Y(We)[0]-me,Y(We)[1]-Se):1/0),gt={face:Z,place:it.indexOf(Math.min(...it))},[k]=d.presses,Me=Ke&&!s&&k?.face===Z&&k.place!==gt.place;tt(Me?[k,gt]:[gt]).catch(({message:$e})=>r("trouble").textContent=$e)}}),await L(),Bt.watch(),window.instobjExplore={state:()=>d,idle:()=>!M&&!x&&!F&&!T,exact:()=>a.scene.endsWith("full"),latencies:()=>_,forget:()=>_.length=0,where:(Z,me)=>R.where(Z,me,f),at:(Z,me)=>R.at(Z,me),dent:()=>g.deepest(),map:()=>Array.from(l.map_live.data)},i.querySelector("#instobj-explore").dataset.ready="yes"}function cg({text:i,magnets:e,sensors:t}){let n=[...e.map(s=>`magnet ${s+1}`),...t.map(s=>`chip ${s+1}`)];return n.length?`${n.join(", ")}: ${i}`:i}function uw(i,e){let t=Ba("tr",{});return t.append(Ba("th",{textContent:i})),e.forEach(n=>t.insertCell().append(n)),t}var fw=i=>[Math.min(...i),Math.max(...i)];function hg(i,e){Object.entries(i).forEach(([t,n])=>t!=="positions_mm"&&Array.isArray(n)&&e(n))}function dw(i,e,t){let s=Array.from({length:81},(o,a)=>[a%9/4-1,Math.floor(a/9)/4-1]).map(o=>o.map((a,l)=>dg(a*Math.min(.55*e.half_mm[l],t[l])))),r=o=>Math.min(...i.map(([a,l])=>Math.hypot(a-o[0],l-o[1])),1/0);return s.sort((o,a)=>r(a)-r(o))}function pw({content:i,arrays:e},t){let n=new Qt({color:on.silicone,transparent:!0}),s=gh(Oi(e,"silicone"),n,[]);if(s.back.visible=!1,s.front.renderOrder=2,t.scene.add(s.group,Na(s.front.geometry,[])),e.core_mm){let u=new wt(Oi(e,"core"),new Qt({color:on.core,transparent:!0,opacity:.35,depthWrite:!1}));u.add(Na(u.geometry,[])),t.scene.add(u)}i.faces.forEach(u=>Oa(u,t));let r=u=>{n.opacity=u,n.depthWrite=u>.95,t.redraw()},o=new G,a=Cn(e.silicone_mm);function l(u){let{position:f}=s.front.geometry.attributes;f.array.set(a),u.forEach(h=>mw(f.array,a,h,i.thickness_mm)),f.needsUpdate=!0,s.front.geometry.computeVertexNormals()}return{silicone:s,offset:()=>o,fade:r,bend:l,deepest:()=>s.front.geometry.attributes.position.array.reduce((u,f,h)=>Math.max(u,Math.abs(f-a[h])),0)}}function mw(i,e,{origin:t,normal:n,profile:s},r){let[o,a]=[new G,s.at(-1)[0]],l=s[1][0];for(let c=0;c<e.length;c+=3){o.set(e[c]-t.x,e[c+1]-t.y,e[c+2]-t.z);let u=-o.dot(n),f=o.addScaledVector(n,u).length();if(f>=a||u>=r)continue;let h=Math.min(s.length-2,Math.floor(f/l)),[d,m]=[1,2].map(g=>s[h][g]+(f/l-h)*(s[h+1][g]-s[h][g])),_=1-Math.max(0,u)/r;o.multiplyScalar(f?m/f:0).addScaledVector(n,-d),i[c]+=_*o.x,i[c+1]+=_*o.y,i[c+2]+=_*o.z}}function gw(i,e){let t=new oa(e,new Qt({transparent:!0,opacity:.9}),sw);Object.assign(t,{renderOrder:3,frustumCulled:!1}),i.scene.add(t);let n=new ct;return s=>{t.count=0,s.forEach(r=>{r.updateMatrixWorld(),r.traverse(({material:o,matrixWorld:a})=>{o&&(t.setColorAt(t.count,n.copy(o.color).add(o.emissive)),t.setMatrixAt(t.count++,a))})}),t.instanceMatrix.needsUpdate=!0,t.instanceColor&&(t.instanceColor.needsUpdate=!0)}}function _w(i,e){let t={magnet:[],sensor:[],board:[]},n={magnet:bs(i,()=>o("magnet",Tf())),sensor:bs(i,()=>o("sensor",Ua(on.chip))),board:bs(i,()=>o("board",Ua(on.board)))},s=!e.magnets_in_shell,r={};function o(T,D){return D.traverse(L=>L.layers.set(ug)),D.traverse(L=>L.material&&(L.userData.colour=L.material.color.getHex())),t[T].push(D),D}let[a,l,c]=[new xi(1,1,1,32),new jn(2,2,2),new jn(2,2,2)].map(T=>gw(i,T)),u={magnet:a,sensor:l,board:c},f=s?"board":"magnet",[h,d]=[null,null];function m(T){h=T;let{magnets:D,chips:L,boards:P}=T;r={magnet:D.length,sensor:P.length,board:P.length};for(let[B,H]of[["magnet",D],["sensor",L],["board",P]])n[B].place(H.map((z,oe)=>({...z,..._(B,oe,z),half:z.half})))}function _(T,D,{at:L,axes:P}){let B=xh(P),H=Math.floor(D/R(T)),z=T===f&&d?.face===H?d.motions[D%R(T)]:null;if(!z||z.includes(null))return{at:L,turn:B};let{x:oe,y:Y,normal:ee}=e.faces[H],ie=(q,ue,le)=>new G().addScaledVector(new G(...oe),q).addScaledVector(new G(...Y),ue).addScaledVector(new G(...ee),le),j=ie(...z.slice(3)),ne=j.length();return ne&&B.premultiply(new cn().setFromAxisAngle(j.divideScalar(ne),ne)),{at:ie(...z).add(new G(...L)).toArray(),turn:B}}function g(T){d=T,h&&m(h)}let p=bs(i,()=>pr("!",1,"#e01b24")),y=[],R=T=>r[T]/e.faces.length,S=T=>(T==="sensor"&&s?t.board:t[T]).slice(0,r[T]),b=(T,D)=>e.faces[Math.floor(D/R(T))],M=(T,D)=>y.some(L=>L[`${T}s`].includes(D%R(T))&&(!L.faces.length||L.faces.includes(b(T,D).number)));i.before.push(T=>{for(let L of["magnet","sensor","board"])t[L].slice(0,r[L]).forEach((P,B)=>P.visible=_o(b(L,B),T)),u[L](t[L].filter(({visible:P})=>P));let D=["magnet","sensor"].flatMap(L=>S(L).filter((P,B)=>P.visible&&M(L,B)));p.place(D.map(L=>({at:L.position.toArray(),turn:L.quaternion,half:Array(3).fill(i.size/6)})))});function x(T,D,L){y=T;for(let P of["magnet","sensor"])S(P).forEach((B,H)=>{let z=D?.kind===P&&D.number===H%R(P)&&(b(P,H)===e.faces[D.face]||P==="magnet"&&L),oe=M(P,H);B.traverse(Y=>{Y.material?.color.setHex(oe?ew:Y.userData.colour),Y.material?.emissive.setHex(oe?6291456:z?5587968:0)})})}function w(T){let D=["magnet","sensor"].flatMap(P=>{let B=S(P).filter(H=>H.visible);return T.intersectObjects(B,!0).map(H=>({...H,kind:P,index:S(P).findIndex(z=>z===H.object||z===H.object.parent)}))}),[L]=D.filter(({index:P})=>P>=0).sort((P,B)=>P.distance-B.distance);return L&&{kind:L.kind,face:Math.floor(L.index/R(L.kind)),number:L.index%R(L.kind),at:S(L.kind)[L.index].position.clone()}}function F(T,D,{camera:L,renderer:P}){let B=P.domElement.getBoundingClientRect(),H=S(T)[D].position.clone().project(L);return[B.left+(H.x+1)/2*B.width,B.top+(1-H.y)/2*B.height]}return{place:m,move:g,paint:x,under:w,where:F,at:(T,D)=>S(T)[D].position.toArray()}}function xw({stage:i,canvas:e,view:t,now:n,frozen:s,choose:r,begin:o,move:a,press:l}){let c=new ys;c.layers.enable(ug);let[u,f]=[new Dn,new G],h=null;function d(_){let g=e.getBoundingClientRect();c.setFromCamera(new Je((_.clientX-g.left)/g.width*2-1,1-(_.clientY-g.top)/g.height*2),t.camera)}function m(_){let{body:g,content:p,maps:y}=n(),[R]=c.intersectObject(g.silicone.front,!1),S=R?Math.max(...[R.face.a,R.face.b,R.face.c].map(b=>y.owner[b])):-1;S>=0&&l(S,...Da(p.faces[S],R.point.x,R.point.y,R.point.z),_)}i.addEventListener("pointerdown",_=>{if(_.target!==e||_.button)return;if(d(_),_.shiftKey)return _.stopPropagation(),m(_.altKey);let{parts:g,content:p}=n(),y=!s&&g.under(c);if(!y)return;_.stopPropagation();let R=new G(...p.faces[y.face].normal);u.setFromNormalAndCoplanarPoint(R,y.at),c.ray.intersectPlane(u,f),h={...y,from:[_.clientX,_.clientY],off:y.at.sub(f),moved:!1},r({kind:y.kind,face:y.face,number:y.number}),e.setPointerCapture(_.pointerId)},!0),e.addEventListener("pointermove",_=>{if(!h||!h.moved&&Math.hypot(_.clientX-h.from[0],_.clientY-h.from[1])<nw||(d(_),!c.ray.intersectPlane(u,f)))return;h.moved||o(),h.moved=!0;let g=n().content.faces[h.face],p=f.add(h.off).sub(new G(...g.centre_mm)),y=fg(n().content,h.kind)[h.face],R=[g.x,g.y].map((S,b)=>dg(Math.min(y[b],Math.max(-y[b],p.dot(new G(...S))))));a(h,R,_.timeStamp)});for(let _ of["pointerup","pointercancel"])e.addEventListener(_,()=>h=null)}document.querySelector("body > #instobj-explore")&&Pf(document.body).catch(i=>{document.querySelector('[data-name="trouble"]').textContent=`The page cannot start: ${i.message}.`,console.warn(i)});function bh(){let i=[];return{note(e,t=performance.now()){i.push([t,e]),i[0][0]<t-6e4&&(i=i.filter(([n])=>n>=t-6e4))},values:()=>i.map(([,e])=>e),since:e=>i.filter(([t])=>t>=e).map(([t])=>t),forget:()=>i=[]}}function wh(i){let e=i.sort((n,s)=>n-s),t=n=>e[Math.min(e.length-1,Math.floor(n*e.length))];return{count:e.length,p50:t(.5),p90:t(.9),p99:t(.99),most:e.at(-1)}}function pg(){let[i,e,t,n]=[bh(),bh(),bh(),bh()],s={shown:0,messages:0,rows:0,dropped:0},r=()=>performance.timeOrigin+performance.now(),o=({readS:h,arrivedS:d})=>1e3*(h||d);function a(h){let{rows:d,dropped:m}=h;n.note(r()-o(h)),s.messages+=1,s.rows+=d,s.dropped=m}function l(h){s.shown+=1,t.note(h)}function c(h){i.note(r()-o(h)),e.note(r()-1e3*h.arrivedS)}function u(){let h=t.since(performance.now()-3e3),d=h.length>1?1e3*(h.length-1)/(h.at(-1)-h[0]):0;return{...s,perSecond:d,latencyMs:wh(i.values()),underwayMs:wh(n.values()),ageMs:wh(e.values()),workMs:wh(t.values())}}function f(){[i,e,t,n].forEach(h=>h.forget()),Object.assign(s,{shown:0,messages:0,rows:0})}return{came:a,drawn:l,seen:c,told:u,forget:f}}var yw=i=>String.fromCharCode(...[0,1,2,3].map(e=>i.getUint8(e)));function mg(i,e){let t=new DataView(i);if(yw(t)==="IOS1")return{state:JSON.parse(new TextDecoder().decode(new Uint8Array(i,4)))};let[n,s,r]=[t.getUint16(4,!0),t.getUint8(6),t.getUint8(7)],o=new Float32Array(i,40),a=1+e,l=(c,u,f,h)=>Array.from({length:c},(d,m)=>h(o.subarray(f+m*u,f+(m+1)*u)));return{number:t.getUint32(8,!0),dropped:t.getUint32(12,!0),arrivedS:t.getFloat64(16,!0),readS:t.getFloat64(24,!0),timeS:t.getFloat64(32,!0),rows:n,values:o,wide:a,contacts:l(s,15,n*a,([c,u,f,h,d,m,..._])=>({face:c,x:u,y:f,radius:h,force:d,halfwidth:m,point:_.slice(0,3),normal:_.slice(3,6),pull:_.slice(6,9)})),labels:l(r,10,n*a+s*15,([c,u,f,h,...d])=>({face:c,x:u,y:f,force:h,point:d.slice(0,3),normal:d.slice(3,6)}))}}var vw="uplot",Sw="u-hz",Mw="u-vt",bw="u-title",ww="u-wrap",Ew="u-under",Tw="u-over",Aw="u-axis",_r="u-off",Cw="u-select",Rw="u-cursor-x",Pw="u-cursor-y",Iw="u-cursor-pt",Lw="u-legend",Dw="u-live",Nw="u-inline",Uw="u-series",Ow="u-marker",gg="u-label",Fw="u-value",za="width",Va="height";var _g="bottom",xo="left",If="right",$f="#000",xg=$f+"0",Lf="mousemove",yg="mousedown",Df="mouseup",vg="mouseenter",Sg="mouseleave",Mg="dblclick",Bw="resize",kw="scroll",bg="change",Rh="dppxchange",Zf="--",Eo=typeof window<"u",Bf=Eo?document:null,vo=Eo?window:null,zw=Eo?navigator:null,Pt,Eh;function kf(){let i=devicePixelRatio;Pt!=i&&(Pt=i,Eh&&Vf(bg,Eh,kf),Eh=matchMedia(`(min-resolution: ${Pt-.001}dppx) and (max-resolution: ${Pt+.001}dppx)`),xr(bg,Eh,kf),vo.dispatchEvent(new CustomEvent(Rh)))}function ci(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function zf(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function $t(i,e,t){i.style[e]=t+"px"}function Fi(i,e,t,n){let s=Bf.createElement(i);return e!=null&&ci(s,e),t?.insertBefore(s,n),s}function bi(i,e){return Fi("div",i,e)}var wg=new WeakMap;function is(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=wg.get(i);r!=o&&(i.style.transform=r,wg.set(i,r),e<0||t<0||e>n||t>s?ci(i,_r):zf(i,_r))}var Eg=new WeakMap;function Tg(i,e,t){let n=e+t,s=Eg.get(i);n!=s&&(Eg.set(i,n),i.style.background=e,i.style.borderColor=t)}var Ag=new WeakMap;function Cg(i,e,t,n){let s=e+""+t,r=Ag.get(i);s!=r&&(Ag.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Jf={passive:!0},Vw={...Jf,capture:!0};function xr(i,e,t,n){e.addEventListener(i,t,n?Vw:Jf)}function Vf(i,e,t,n){e.removeEventListener(i,t,Jf)}Eo&&kf();function Bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:hi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function n0(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var i0=i=>i!=null,s0=i=>i!=null&&i>0,Lh=n0(i0),Gw=n0(s0);function Hw(i,e,t,n=0,s=!1){let r=s?Gw:Lh,o=s?s0:i0;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??zt,l??-zt]}function Dh(i,e,t,n){let s=Ig(i),r=Ig(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ws:r0,a=s==1?hi:wi,l=r==1?wi:hi,c=a(o(bn(i))),u=l(o(bn(e))),f=So(t,c),h=So(t,u);return t==10&&(c<0&&(f=Vt(f,-c)),u<0&&(h=Vt(h,-u))),n||t==2?(i=f*s,e=h*r):(i=c0(i,f),e=Nh(e,h)),[i,e]}function Kf(i,e,t,n){let s=Dh(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var jf=.1,Rg={mode:3,pad:jf},Ha={pad:0,soft:null,mode:0},Ww={min:Ha,max:Ha};function Ph(i,e,t,n){return Uh(t)?Pg(i,e,t):(Ha.pad=t,Ha.soft=n?0:null,Ha.mode=n?3:0,Pg(i,e,Ww))}function At(i,e){return i??e}function Xw(i,e,t){for(e=At(e,0),t=At(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Pg(i,e,t){let n=t.min,s=t.max,r=At(n.pad,0),o=At(s.pad,0),a=At(n.hard,-zt),l=At(s.hard,zt),c=At(n.soft,zt),u=At(s.soft,-zt),f=At(n.mode,0),h=At(s.mode,0),d=e-i,m=ws(d),_=Kn(bn(i),bn(e)),g=ws(_),p=bn(g-m);(d<1e-24||p>10)&&(d=0,(i==0||e==0)&&(d=1e-24,f==2&&c!=zt&&(r=0),h==2&&u!=-zt&&(o=0)));let y=d||_||1e3,R=ws(y),S=So(10,hi(R)),b=y*(d==0?i==0?.1:1:r),M=Vt(c0(i-b,S/10),24),x=i>=c&&(f==1||f==3&&M<=c||f==2&&M>=c)?c:zt,w=Kn(a,M<x&&i>=x?x:ki(x,M)),F=y*(d==0?e==0?.1:1:o),I=Vt(Nh(e+F,S/10),24),T=e<=u&&(h==1||h==3&&I>=u||h==2&&I<=u)?u:-zt,D=ki(l,I>T&&e<=T?T:Kn(T,I));return w==D&&w==0&&(D=100),[w,D]}var qw=new Intl.NumberFormat(Eo?zw.language:"en-US"),Qf=i=>qw.format(i),ui=Math,Ch=ui.PI,bn=ui.abs,hi=ui.floor,Mn=ui.round,wi=ui.ceil,ki=ui.min,Kn=ui.max,So=ui.pow,Ig=ui.sign,ws=ui.log10,r0=ui.log2,Yw=(i,e=1)=>ui.sinh(i)*e,Nf=(i,e=1)=>ui.asinh(i/e),zt=1/0;function Lg(i){return(ws((i^i>>31)-(i>>31))|0)+1}function Gf(i,e,t){return ki(Kn(i,e),t)}function o0(i){return typeof i=="function"}function bt(i){return o0(i)?i:()=>i}var $w=()=>{},a0=i=>i,l0=(i,e)=>e,Zw=i=>null,Dg=i=>!0,Ng=(i,e)=>i==e,Jw=/\.\d*?(?=9{6,}|0{6,})/gm,yr=i=>{if(u0(i)||js.has(i))return i;let e=`${i}`,t=e.match(Jw);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${yr(s)}e${r}`}return Vt(i,n)};function mr(i,e){return yr(Vt(yr(i/e))*e)}function Nh(i,e){return yr(wi(yr(i/e))*e)}function c0(i,e){return yr(hi(yr(i/e))*e)}function Vt(i,e=0){if(u0(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Mn(n)/t}var js=new Map;function h0(i){return((""+i).split(".")[1]||"").length}function Xa(i,e,t,n){let s=[],r=n.map(h0);for(let o=e;o<t;o++){let a=bn(o),l=Vt(So(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=i==10?u:Vt(u,f);s.push(h),js.set(h,f)}}return s}var Wa={},ed=[],Mo=[null,null],Ks=Array.isArray,u0=Number.isInteger,Kw=i=>i===void 0;function Ug(i){return typeof i=="string"}function Uh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function jw(i){return i!=null&&typeof i=="object"}var Qw=Object.getPrototypeOf(Uint8Array),f0="__proto__";function bo(i,e=Uh){let t;if(Ks(i)){let n=i.find(s=>s!=null);if(Ks(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=bo(i[s],e)}else t=i.slice()}else if(i instanceof Qw)t=i.slice();else if(e(i)){t={};for(let n in i)n!=f0&&(t[n]=bo(i[n],e))}else t=i;return t}function _n(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=f0&&(Uh(i[s])?_n(i[s],bo(n[s])):i[s]=bo(n[s]))}return i}var eE=0,tE=1,nE=2;function iE(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function sE(i,e){if(aE(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return lE(o[0])||(o=oE(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:tE,d=[];for(let m=0;m<u.length;m++){let _=u[m],g=r.get(l[m]);_===null?h!=eE&&(f[g]=_,h==nE&&d.push(g)):f[g]=_}iE(f,d,s),n.push(f)}}return n}var rE=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function oE(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function aE(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function lE(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Kn(1,hi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var d0=["January","February","March","April","May","June","July","August","September","October","November","December"],p0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function m0(i){return i.slice(0,3)}var cE=p0.map(m0),hE=d0.map(m0),uE={MMMM:d0,MMM:hE,WWWW:p0,WWW:cE};function ka(i){return(i<10?"0":"")+i}function fE(i){return(i<10?"00":i<100?"0":"")+i}var dE={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>ka(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ka(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>ka(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ka(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ka(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>fE(i.getMilliseconds())};function td(i,e){e=e||uE;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?dE[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var pE=new Intl.DateTimeFormat().resolvedOptions().timeZone;function mE(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==pE?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var g0=i=>i%1==0,Ih=[1,2,2.5,5],gE=Xa(10,-32,0,Ih),_0=Xa(10,0,32,Ih),_E=_0.filter(g0),gr=gE.concat(_0),nd=`
`,x0="{YYYY}",Og=nd+x0,y0="{M}/{D}",Ga=nd+y0,Th=Ga+"/{YY}",v0="{aa}",xE="{h}:{mm}",yo=xE+v0,Fg=nd+yo,Bg=":{ss}",Lt=null;function S0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Xa(10,0,3,Ih).filter(g0):Xa(10,-3,0,Ih)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,x0,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",Og,Lt,Lt,Lt,Lt,Lt,1],[s,y0,Og,Lt,Lt,Lt,Lt,Lt,1],[n,"{h}"+v0,Th,Lt,Ga,Lt,Lt,Lt,1],[t,yo,Th,Lt,Ga,Lt,Lt,Lt,1],[e,Bg,Th+" "+yo,Lt,Ga+" "+yo,Lt,Fg,Lt,1],[i,Bg+".{fff}",Th+" "+yo,Lt,Ga+" "+yo,Lt,Fg,Lt,1]];function u(f){return(h,d,m,_,g,p)=>{let y=[],R=g>=o,S=g>=r&&g<o,b=f(m),M=Vt(b*i,3),x=Uf(b.getFullYear(),R?0:b.getMonth(),S||R?1:b.getDate()),w=Vt(x*i,3);if(S||R){let F=S?g/r:0,I=R?g/o:0,T=M==w?M:Vt(Uf(x.getFullYear()+I,x.getMonth()+F,1)*i,3),D=new Date(Mn(T/i)),L=D.getFullYear(),P=D.getMonth();for(let B=0;T<=_;B++){let H=Uf(L+I*B,P+F*B,1),z=H-f(Vt(H*i,3));T=Vt((+H+z)*i,3),T<=_&&y.push(T)}}else{let F=g>=s?s:g,I=hi(m)-hi(M),T=w+I+Nh(M-w,F);y.push(T);let D=f(T),L=D.getHours()+D.getMinutes()/t+D.getSeconds()/n,P=g/n,B=h.axes[d]._space,H=p/B;for(;T=Vt(T+g,i==1?0:3),!(T>_);)if(P>1){let z=hi(Vt(L+P,6))%24,ee=f(T).getHours()-z;ee>1&&(ee=-1),T-=ee*n,L=(L+P)%24;let ie=y[y.length-1];Vt((T-ie)/g,3)*H>=.7&&y.push(T)}else y.push(T)}return y}}return[l,c,u]}var[yE,vE,SE]=S0(1),[ME,bE,wE]=S0(.001);Xa(2,-53,53,[1]);function kg(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function zg(i,e){return(t,n,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,f,h,d;return n.map(m=>{let _=i(m),g=_.getFullYear(),p=_.getMonth(),y=_.getDate(),R=_.getHours(),S=_.getMinutes(),b=_.getSeconds(),M=g!=l&&a[2]||p!=c&&a[3]||y!=u&&a[4]||R!=f&&a[5]||S!=h&&a[6]||b!=d&&a[7]||a[1];return l=g,c=p,u=y,f=R,h=S,d=b,M(_)})}}function EE(i,e){let t=td(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Uf(i,e,t){return new Date(i,e,t)}function Vg(i,e){return e(i)}var TE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Gg(i,e){return(t,n,s,r)=>r==null?Zf:e(i(n))}function AE(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function CE(i,e){return i.series[e].fill(i,e)}var RE={show:!0,live:!0,isolate:!1,mount:$w,markers:{show:!0,width:2,stroke:AE,fill:CE,dash:"solid"},idx:null,idxs:null,values:[]};function PE(i,e){let t=i.cursor.points,n=bi(),s=t.size(i,e);$t(n,za,s),$t(n,Va,s);let r=s/-2;$t(n,"marginLeft",r),$t(n,"marginTop",r);let o=t.width(i,e,s);return o&&$t(n,"borderWidth",o),n}function IE(i,e){let t=i.series[e].points;return t._fill||t._stroke}function LE(i,e){let t=i.series[e].points;return t._stroke||t._fill}function DE(i,e){return i.series[e].points.size}var Of=[0,0];function NE(i,e,t){return Of[0]=e,Of[1]=t,Of}function Ah(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Ff(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var UE={show:!0,x:!0,y:!0,lock:!1,move:NE,points:{one:!1,show:PE,size:DE,width:0,stroke:LE,fill:IE},bind:{mousedown:Ah,mouseup:Ah,click:Ah,dblclick:Ah,mousemove:Ff,mouseleave:Ff,mouseenter:Ff},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},M0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},id=_n({},M0,{filter:l0}),b0=_n({},id,{size:10}),w0=_n({},M0,{show:!1}),sd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',E0="bold "+sd,T0=1.5,Hg={show:!0,scale:"x",stroke:$f,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:E0,side:2,grid:id,ticks:b0,border:w0,font:sd,lineGap:T0,rotate:0},OE="Value",FE="Time",Wg={show:!0,scale:"x",auto:!1,sorted:1,min:zt,max:-zt,idxs:[]};function BE(i,e,t,n,s){return e.map(r=>r==null?"":Qf(r))}function kE(i,e,t,n,s,r,o){let a=[],l=js.get(s)||0;t=o?t:Vt(Nh(t,s),l);for(let c=t;c<=n;c=Vt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Hf(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?ws:r0,u=hi(c(t));s=So(l,u),l==10&&(s=gr[Bi(s,gr)]);let f=t,h=s*l;l==10&&(h=gr[Bi(h,gr)]);do a.push(f),f=f+s,l==10&&!js.has(f)&&(f=Vt(f,js.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=gr[Bi(h,gr)]));while(f<=n);return a}function zE(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Hf(i,e,Kn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?Hf(i,e,Kn(l,-n),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var A0=/./,VE=/[12357]/,GE=/[125]/,Xg=/1/,Wf=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function HE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?A0:l(7,o)-u>=c?VE:l(5,o)-u>=c?GE:Xg;if(f==Xg){let h=bn(l(1,o)-u);if(h<c)return Wf(e.slice().reverse(),a.distr,f,wi(c/h)).reverse()}return Wf(e,a.distr,f,1)}function WE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=bn(l(1,o)-l(2,o));return c<a?Wf(e.slice().reverse(),3,A0,wi(a/c)).reverse():e}function XE(i,e,t,n){return n==null?Zf:e==null?"":Qf(e)}var qg={show:!0,scale:"y",stroke:$f,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:E0,side:3,grid:id,ticks:b0,border:w0,font:sd,lineGap:T0,rotate:0};function qE(i,e){let t=3+(i||1)*2;return Vt(t*e,3)}function YE(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=bn(o-r),l=i.series[e],c=a/(l.points.space*Pt);return n[1]-n[0]<=c}var Yg={scale:null,auto:!0,sorted:0,min:zt,max:-zt},C0=(i,e,t,n,s)=>s,$g={show:!0,auto:!0,sorted:0,gaps:C0,alpha:1,facets:[_n({},Yg,{scale:"x"}),_n({},Yg,{scale:"y"})]},Zg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:C0,alpha:1,points:{show:YE,filter:null},values:null,min:zt,max:-zt,idxs:[],path:null,clip:null};function $E(i,e,t,n,s){return t/10}var R0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},ZE=_n({},R0,{time:!1,ori:1}),Jg={};function P0(i,e){let t=Jg[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(Jg[i]=t)),t}var wo=1,Xf=2;function vr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],f=n==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,m=a.width,_=a.height,g=i.valToPosH,p=i.valToPosV;return u.ori==0?t(s,l,c,u,f,g,p,h,d,m,_,Fh,To,kh,L0,N0):t(s,l,c,u,f,p,g,d,h,_,m,Bh,Ao,ad,D0,U0)}function rd(i,e){let t=0,n=0,s=At(i.bands,ed);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function JE(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Es(i,e,t,n,s,r){return vr(i,e,(o,a,l,c,u,f,h,d,m,_,g)=>{let p=o.pxRound,y=c.dir*(c.ori==0?1:-1),R=c.ori==0?To:Ao,S,b;y==1?(S=t,b=n):(S=n,b=t);let M=p(f(a[S],c,_,d)),x=p(h(l[S],u,g,m)),w=p(f(a[b],c,_,d)),F=p(h(r==1?u.max:u.min,u,g,m)),I=new Path2D(s);return R(I,w,F),R(I,M,F),R(I,M,x),I})}function Oh(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?kh:ad,l=t;for(let f=0;f<i.length;f++){let h=i[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,n,d,n+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function KE(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function od(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=n&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(i[f]),m=h==f?d:r(i[h]),_=f-s;d=o<=0&&_>=0&&_<l?r(i[_]):d;let p=h+s;m=o>=0&&p>=0&&p<l?r(i[p]):m,m>=d&&a.push([d,m])}return a}function Kg(i){return i==0?a0:i==1?Mn:e=>mr(e,i)}function I0(i){let e=i==0?Fh:Bh,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=ki(c,a/2,l/2),u=ki(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Fh=(i,e,t)=>{i.moveTo(e,t)},Bh=(i,e,t)=>{i.moveTo(t,e)},To=(i,e,t)=>{i.lineTo(e,t)},Ao=(i,e,t)=>{i.lineTo(t,e)},kh=I0(0),ad=I0(1),L0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},D0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},N0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},U0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function O0(i){return(e,t,n,s,r)=>vr(e,t,(o,a,l,c,u,f,h,d,m,_,g)=>{let{pxRound:p,points:y}=o,R,S;c.ori==0?(R=Fh,S=L0):(R=Bh,S=D0);let b=Vt(y.width*Pt,3),M=(y.size-y.width)/2*Pt,x=Vt(M*2,3),w=new Path2D,F=new Path2D,{left:I,top:T,width:D,height:L}=e.bbox;kh(F,I-x,T-x,D+x*2,L+x*2);let P=B=>{if(l[B]!=null){let H=p(f(a[B],c,_,d)),z=p(h(l[B],u,g,m));R(w,H+M,z),S(w,H,z,M,0,Ch*2)}};if(r)r.forEach(P);else for(let B=n;B<=s;B++)P(B);return{stroke:b>0?w:null,fill:w,clip:F,flags:wo|Xf}})}function F0(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var jE=F0(To),QE=F0(Ao);function B0(i){let e=At(i?.alignGaps,0);return(t,n,s,r)=>vr(t,n,(o,a,l,c,u,f,h,d,m,_,g)=>{[s,r]=Lh(l,s,r);let p=o.pxRound,y=L=>p(f(L,c,_,d)),R=L=>p(h(L,u,g,m)),S,b;c.ori==0?(S=To,b=jE):(S=Ao,b=QE);let M=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wo},w=x.stroke,F=!1;if(r-s>=_*4){let L=ne=>t.posToVal(ne,c.key,!0),P=null,B=null,H,z,oe,Y=y(a[M==1?s:r]),ee=y(a[s]),ie=y(a[r]),j=L(M==1?ee+1:ie-1);for(let ne=M==1?s:r;ne>=s&&ne<=r;ne+=M){let q=a[ne],le=(M==1?q<j:q>j)?Y:y(q),pe=l[ne];le==Y?pe!=null?(z=pe,P==null?(S(w,le,R(z)),H=P=B=z):z<P?P=z:z>B&&(B=z)):pe===null&&(F=!0):(P!=null&&b(w,Y,R(P),R(B),R(H),R(z)),pe!=null?(z=pe,S(w,le,R(z)),P=B=H=z):(P=B=null,pe===null&&(F=!0)),Y=le,j=L(Y+M))}P!=null&&P!=B&&oe!=Y&&b(w,Y,R(P),R(B),R(H),R(z))}else for(let L=M==1?s:r;L>=s&&L<=r;L+=M){let P=l[L];P===null?F=!0:P!=null&&S(w,y(a[L]),R(P))}let[T,D]=rd(t,n);if(o.fill!=null||T!=0){let L=x.fill=new Path2D(w),P=o.fillTo(t,n,o.min,o.max,T),B=R(P),H=y(a[s]),z=y(a[r]);M==-1&&([z,H]=[H,z]),S(L,z,B),S(L,H,B)}if(!o.spanGaps){let L=[];F&&L.push(...od(a,l,s,r,M,y,e)),x.gaps=L=o.gaps(t,n,s,r,L),x.clip=Oh(L,c.ori,d,m,_,g)}return D!=0&&(x.band=D==2?[Es(t,n,s,r,w,-1),Es(t,n,s,r,w,1)]:Es(t,n,s,r,w,D)),x})}function e1(i){let e=At(i.align,1),t=At(i.ascDesc,!1),n=At(i.alignGaps,0),s=At(i.extend,!1);return(r,o,a,l)=>vr(r,o,(c,u,f,h,d,m,_,g,p,y,R)=>{[a,l]=Lh(f,a,l);let S=c.pxRound,{left:b,width:M}=r.bbox,x=ee=>S(m(ee,h,y,g)),w=ee=>S(_(ee,d,R,p)),F=h.ori==0?To:Ao,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wo},T=I.stroke,D=h.dir*(h.ori==0?1:-1),L=w(f[D==1?a:l]),P=x(u[D==1?a:l]),B=P,H=P;s&&e==-1&&(H=b,F(T,H,L)),F(T,P,L);for(let ee=D==1?a:l;ee>=a&&ee<=l;ee+=D){let ie=f[ee];if(ie==null)continue;let j=x(u[ee]),ne=w(ie);e==1?F(T,j,L):F(T,B,ne),F(T,j,ne),L=ne,B=j}let z=B;s&&e==1&&(z=b+M,F(T,z,L));let[oe,Y]=rd(r,o);if(c.fill!=null||oe!=0){let ee=I.fill=new Path2D(T),ie=c.fillTo(r,o,c.min,c.max,oe),j=w(ie);F(ee,z,j),F(ee,H,j)}if(!c.spanGaps){let ee=[];ee.push(...od(u,f,a,l,D,x,n));let ie=c.width*Pt/2,j=t||e==1?ie:-ie,ne=t||e==-1?-ie:ie;ee.forEach(q=>{q[0]+=j,q[1]+=ne}),I.gaps=ee=c.gaps(r,o,a,l,ee),I.clip=Oh(ee,h.ori,g,p,y,R)}return Y!=0&&(I.band=Y==2?[Es(r,o,a,l,T,-1),Es(r,o,a,l,T,1)]:Es(r,o,a,l,T,Y)),I})}function jg(i,e,t,n,s,r,o=zt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=bn(i[l]-i[a]);u<c&&(c=u,o=bn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function t1(i){i=i||Wa;let e=At(i.size,[.6,zt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=At(e[1],zt),l=At(e[2],1),c=At(i.disp,Wa),u=At(i.each,d=>{}),{fill:f,stroke:h}=c;return(d,m,_,g)=>vr(d,m,(p,y,R,S,b,M,x,w,F,I,T)=>{let D=p.pxRound,L=t,P=n*Pt,B=a*Pt,H=l*Pt,z,oe;S.ori==0?[z,oe]=r(d,m):[oe,z]=r(d,m);let Y=S.dir*(S.ori==0?1:-1),ee=S.ori==0?kh:ad,ie=S.ori==0?u:(Me,$e,We,ye,mt,ke,et)=>{u(Me,$e,We,mt,ye,et,ke)},j=At(d.bands,ed).find(Me=>Me.series[0]==m),ne=j!=null?j.dir:0,q=p.fillTo(d,m,p.min,p.max,ne),ue=D(x(q,b,T,F)),le,pe,de,Ue=I,Ve=D(p.width*Pt),De=!1,Qe=null,tt=null,Be=null,Bt=null;f!=null&&(Ve==0||h!=null)&&(De=!0,Qe=f.values(d,m,_,g),tt=new Map,new Set(Qe).forEach(Me=>{Me!=null&&tt.set(Me,new Path2D)}),Ve>0&&(Be=h.values(d,m,_,g),Bt=new Map,new Set(Be).forEach(Me=>{Me!=null&&Bt.set(Me,new Path2D)})));let{x0:Dt,size:en}=c;if(Dt!=null&&en!=null){L=1,y=Dt.values(d,m,_,g),Dt.unit==2&&(y=y.map(We=>d.posToVal(w+We*I,S.key,!0)));let Me=en.values(d,m,_,g);en.unit==2?pe=Me[0]*I:pe=M(Me[0],S,I,w)-M(0,S,I,w),Ue=jg(y,R,M,S,I,w,Ue),de=Ue-pe+P}else Ue=jg(y,R,M,S,I,w,Ue),de=Ue*o+P,pe=Ue-de;de<1&&(de=0),Ve>=pe/2&&(Ve=0),de<5&&(D=a0);let Z=de>0,me=Ue-de-(Z?Ve:0);pe=D(Gf(me,H,B)),le=(L==0?pe/2:L==Y?0:pe)-L*Y*((L==0?P/2:0)+(Z?Ve/2:0));let Se={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Ke=De?null:new Path2D,it=null;if(j!=null)it=d.data[j.series[1]];else{let{y0:Me,y1:$e}=c;Me!=null&&$e!=null&&(R=$e.values(d,m,_,g),it=Me.values(d,m,_,g))}let gt=z*pe,k=oe*pe;for(let Me=Y==1?_:g;Me>=_&&Me<=g;Me+=Y){let $e=R[Me];if($e==null)continue;if(it!=null){let $=it[Me]??0;if($e-$==0)continue;ue=x($,b,T,F)}let We=S.distr!=2||c!=null?y[Me]:Me,ye=M(We,S,I,w),mt=x(At($e,q),b,T,F),ke=D(ye-le),et=D(Kn(mt,ue)),N=D(ki(mt,ue)),E=et-N;if($e!=null){let $=$e<0?k:gt,_e=$e<0?gt:k;De?(Ve>0&&Be[Me]!=null&&ee(Bt.get(Be[Me]),ke,N+hi(Ve/2),pe,Kn(0,E-Ve),$,_e),Qe[Me]!=null&&ee(tt.get(Qe[Me]),ke,N+hi(Ve/2),pe,Kn(0,E-Ve),$,_e)):ee(Ke,ke,N+hi(Ve/2),pe,Kn(0,E-Ve),$,_e),ie(d,m,Me,ke-Ve/2,N,pe+Ve,E)}}return Ve>0?Se.stroke=De?Bt:Ke:De||(Se._fill=p.width==0?p._fill:p._stroke??p._fill,Se.width=0),Se.fill=De?tt:Ke,Se})}function n1(i,e){let t=At(e?.alignGaps,0);return(n,s,r,o)=>vr(n,s,(a,l,c,u,f,h,d,m,_,g,p)=>{[r,o]=Lh(c,r,o);let y=a.pxRound,R=z=>y(h(z,u,g,m)),S=z=>y(d(z,f,p,_)),b,M,x;u.ori==0?(b=Fh,x=To,M=N0):(b=Bh,x=Ao,M=U0);let w=u.dir*(u.ori==0?1:-1),F=R(l[w==1?r:o]),I=F,T=[],D=[];for(let z=w==1?r:o;z>=r&&z<=o;z+=w)if(c[z]!=null){let Y=l[z],ee=R(Y);T.push(I=ee),D.push(S(c[z]))}let L={stroke:i(T,D,b,x,M,y),fill:null,clip:null,band:null,gaps:null,flags:wo},P=L.stroke,[B,H]=rd(n,s);if(a.fill!=null||B!=0){let z=L.fill=new Path2D(P),oe=a.fillTo(n,s,a.min,a.max,B),Y=S(oe);x(z,I,Y),x(z,F,Y)}if(!a.spanGaps){let z=[];z.push(...od(l,c,r,o,w,R,t)),L.gaps=z=a.gaps(n,s,r,o,z),L.clip=Oh(z,u.ori,m,_,g,p)}return H!=0&&(L.band=H==2?[Es(n,s,r,o,P,-1),Es(n,s,r,o,P,1)]:Es(n,s,r,o,P,H)),L})}function i1(i){return n1(s1,i)}function s1(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=i[h+1]-i[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,i[h]+f[h]/3,e[h]+l[h]*f[h]/3,i[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,i[h+1],e[h+1])}return a}var qf=new Set;function Qg(){for(let i of qf)i.syncRect(!0)}Eo&&(xr(Bw,vo,Qg),xr(kw,vo,Qg,!0),xr(Rh,vo,()=>{Fn.pxRatio=Pt}));var r1=B0(),o1=O0();function e0(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Yf(r,o,e,t))}function a1(i,e){return i.map((t,n)=>n==0?{}:_n({},e,t))}function Yf(i,e,t,n){return _n({},e==0?t:n,i)}function k0(i,e,t){return e==null?Mo:[e,t]}var l1=k0;function c1(i,e,t){return e==null?Mo:Ph(e,t,jf,!0)}function z0(i,e,t,n){return e==null?Mo:Dh(e,t,i.scales[n].log,!1)}var h1=z0;function V0(i,e,t,n){return e==null?Mo:Kf(e,t,i.scales[n].log,!1)}var u1=V0;function f1(i,e,t,n,s){let r=Kn(Lg(i),Lg(e)),o=e-i,a=Bi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?js.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function t0(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Mn((t=+s)*Pt))+"px"),[i,e,t]}function d1(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Vt(e[2]*Pt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Fn(i,e,t){let n={mode:At(i.mode,1)},s=n.mode;function r(v,A,U,O){let X=A.valToPct(v);return O+U*(A.dir==-1?1-X:X)}function o(v,A,U,O){let X=A.valToPct(v);return O+U*(A.dir==-1?X:1-X)}function a(v,A,U,O){return A.ori==0?r(v,A,U,O):o(v,A,U,O)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=bi(vw);if(i.id!=null&&(c.id=i.id),ci(c,i.class),i.title){let v=bi(bw,c);v.textContent=i.title}let u=Fi("canvas"),f=n.ctx=u.getContext("2d"),h=bi(ww,c);xr("click",h,v=>{v.target===m&&(Ht!=Ar||Zt!=Cr)&&Ln.click(n,v)},!0);let d=n.under=bi(Ew,h);h.appendChild(u);let m=n.over=bi(Tw,h);i=bo(i);let _=+At(i.pxAlign,1),g=Kg(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let p=i.ms||.001,y=n.series=s==1?e0(i.series||[],Wg,Zg,!1):a1(i.series||[null],$g),R=n.axes=e0(i.axes||[],Hg,qg,!0),S=n.scales={},b=n.bands=i.bands||[];b.forEach(v=>{v.fill=bt(v.fill||null),v.dir=At(v.dir,-1)});let M=s==2?y[1].facets[0].scale:y[0].scale,x={axes:as,series:xt},w=(i.drawOrder||["axes","series"]).map(v=>x[v]);function F(v){let A=v.distr==3?U=>ws(U>0?U:v.clamp(n,U,v.min,v.max,v.key)):v.distr==4?U=>Nf(U,v.asinh):v.distr==100?U=>v.fwd(U):U=>U;return U=>{let O=A(U),{_min:X,_max:Q}=v,fe=Q-X;return(O-X)/fe}}function I(v){let A=S[v];if(A==null){let U=(i.scales||Wa)[v]||Wa;if(U.from!=null){I(U.from);let O=_n({},S[U.from],U,{key:v});O.valToPct=F(O),S[v]=O}else{A=S[v]=_n({},v==M?R0:ZE,U),A.key=v;let O=A.time,X=A.range,Q=Ks(X);if((v!=M||s==2&&!O)&&(Q&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Rg:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Rg:{mode:1,hard:X[1],soft:X[1]}},Q=!1),!Q&&Uh(X))){let fe=X;X=(xe,Te,Fe)=>Te==null?Mo:Ph(Te,Fe,fe)}A.range=bt(X||(O?l1:v==M?A.distr==3?h1:A.distr==4?u1:k0:A.distr==3?z0:A.distr==4?V0:c1)),A.auto=bt(Q?!1:A.auto),A.clamp=bt(A.clamp||$E),A._min=A._max=null,A.valToPct=F(A)}}}I("x"),I("y"),s==1&&y.forEach(v=>{I(v.scale)}),R.forEach(v=>{I(v.scale)});for(let v in i.scales)I(v);let T=S[M],D=T.distr,L,P;T.ori==0?(ci(c,Sw),L=r,P=o):(ci(c,Mw),L=o,P=r);let B={};for(let v in S){let A=S[v];(A.min!=null||A.max!=null)&&(B[v]={min:A.min,max:A.max},A.min=A.max=null)}let H=i.tzDate||(v=>new Date(Mn(v/p))),z=i.fmtDate||td,oe=p==1?SE(H):wE(H),Y=zg(H,kg(p==1?vE:bE,z)),ee=Gg(H,Vg(TE,z)),ie=[],j=n.legend=_n({},RE,i.legend),ne=n.cursor=_n({},UE,{drag:{y:s==2}},i.cursor),q=j.show,ue=ne.show,le=j.markers;j.idxs=ie,le.width=bt(le.width),le.dash=bt(le.dash),le.stroke=bt(le.stroke),le.fill=bt(le.fill);let pe,de,Ue,Ve=[],De=[],Qe,tt=!1,Be={};if(j.live){let v=y[1]?y[1].values:null;tt=v!=null,Qe=tt?v(n,1,0):{_:0};for(let A in Qe)Be[A]=Zf}if(q)if(pe=Fi("table",Lw,c),Ue=Fi("tbody",null,pe),j.mount(n,pe),tt){de=Fi("thead",null,pe,Ue);let v=Fi("tr",null,de);Fi("th",null,v);for(var Bt in Qe)Fi("th",gg,v).textContent=Bt}else ci(pe,Nw),j.live&&ci(pe,Dw);let Dt={show:!0},en={show:!1};function Z(v,A){if(A==0&&(tt||!j.live||s==2))return Mo;let U=[],O=Fi("tr",Uw,Ue,Ue.childNodes[A]);ci(O,v.class),v.show||ci(O,_r);let X=Fi("th",null,O);if(le.show){let xe=bi(Ow,X);if(A>0){let Te=le.width(n,A);Te&&(xe.style.border=Te+"px "+le.dash(n,A)+" "+le.stroke(n,A)),xe.style.background=le.fill(n,A)}}let Q=bi(gg,X);v.label instanceof HTMLElement?Q.appendChild(v.label):Q.textContent=v.label,A>0&&(le.show||(Q.style.color=v.width>0?le.stroke(n,A):le.fill(n,A)),Se("click",X,xe=>{if(ne._lock)return;ot(xe);let Te=y.indexOf(v);if((xe.ctrlKey||xe.metaKey)!=j.isolate){let Fe=y.some((ze,He)=>He>0&&He!=Te&&ze.show);y.forEach((ze,He)=>{He>0&&Wi(He,Fe?He==Te?Dt:en:Dt,!0,dn.setSeries)})}else Wi(Te,{show:!v.show},!0,dn.setSeries)},!1),at&&Se(vg,X,xe=>{ne._lock||(ot(xe),Wi(y.indexOf(v),Pr,!0,dn.setSeries))},!1));for(var fe in Qe){let xe=Fi("td",Fw,O);xe.textContent="--",U.push(xe)}return[O,U]}let me=new Map;function Se(v,A,U,O=!0){let X=me.get(A)||{},Q=ne.bind[v](n,A,U,O);Q&&(xr(v,A,X[v]=Q),me.set(A,X))}function Ke(v,A,U){let O=me.get(A)||{};for(let X in O)(v==null||X==v)&&(Vf(X,A,O[X]),delete O[X]);v==null&&me.delete(A)}let it=0,gt=0,k=0,Me=0,$e=0,We=0,ye=$e,mt=We,ke=k,et=Me,N=0,E=0,$=0,_e=0;n.bbox={};let he=!1,we=!1,Ee=!1,se=!1,ae=!1,ve=!1;function V(v,A,U){(U||v!=n.width||A!=n.height)&&ce(v,A),dt(!1),Ee=!0,we=!0,Bn()}function ce(v,A){n.width=it=k=v,n.height=gt=Me=A,$e=We=0,Ae(),Ze();let U=n.bbox;N=U.left=mr($e*Pt,.5),E=U.top=mr(We*Pt,.5),$=U.width=mr(k*Pt,.5),_e=U.height=mr(Me*Pt,.5)}let re=3;function Ce(){let v=!1,A=0;for(;!v;){A++;let U=wr(A),O=Hi(A);v=A==re||U&&O,v||(ce(n.width,n.height),we=!0)}}function be({width:v,height:A}){V(v,A)}n.setSize=be;function Ae(){let v=!1,A=!1,U=!1,O=!1;R.forEach((X,Q)=>{if(X.show&&X._show){let{side:fe,_size:xe}=X,Te=fe%2,Fe=X.label!=null?X.labelSize:0,ze=xe+Fe;ze>0&&(Te?(k-=ze,fe==3?($e+=ze,O=!0):U=!0):(Me-=ze,fe==0?(We+=ze,v=!0):A=!0))}}),Vi[0]=v,Vi[1]=U,Vi[2]=A,Vi[3]=O,k-=Ei[1]+Ei[3],$e+=Ei[3],Me-=Ei[2]+Ei[0],We+=Ei[0]}function Ze(){let v=$e+k,A=We+Me,U=$e,O=We;function X(Q,fe){switch(Q){case 1:return v+=fe,v-fe;case 2:return A+=fe,A-fe;case 3:return U-=fe,U+fe;case 0:return O-=fe,O+fe}}R.forEach((Q,fe)=>{if(Q.show&&Q._show){let xe=Q.side;Q._pos=X(xe,Q._size),Q.label!=null&&(Q._lpos=X(xe,Q.labelSize))}})}if(ne.dataIdx==null){let v=ne.hover,A=v.skip=new Set(v.skip??[]);A.add(void 0);let U=v.prox=bt(v.prox),O=v.bias??=0;ne.dataIdx=(X,Q,fe,xe)=>{if(Q==0)return fe;let Te=fe,Fe=U(X,Q,fe,xe)??zt,ze=Fe>=0&&Fe<zt,He=T.ori==0?k:Me,ut=ne.left,Ct=e[0],Tt=e[Q];if(A.has(Tt[fe])){Te=null;let vt=null,st=null,je;if(O==0||O==-1)for(je=fe;vt==null&&je-- >0;)A.has(Tt[je])||(vt=je);if(O==0||O==1)for(je=fe;st==null&&je++<Tt.length;)A.has(Tt[je])||(st=je);if(vt!=null||st!=null)if(ze){let Xt=vt==null?-1/0:L(Ct[vt],T,He,0),sn=st==null?1/0:L(Ct[st],T,He,0),An=ut-Xt,Ft=sn-ut;An<=Ft?An<=Fe&&(Te=vt):Ft<=Fe&&(Te=st)}else Te=st==null?vt:vt==null?st:fe-vt<=st-fe?vt:st}else ze&&bn(ut-L(Ct[fe],T,He,0))>Fe&&(Te=null);return Te}}let ot=v=>{ne.event=v};ne.idxs=ie,ne._lock=!1;let ge=ne.points;ge.show=bt(ge.show),ge.size=bt(ge.size),ge.stroke=bt(ge.stroke),ge.width=bt(ge.width),ge.fill=bt(ge.fill);let Xe=n.focus=_n({},i.focus||{alpha:.3},ne.focus),at=Xe.prox>=0,Ie=at&&ge.one,ft=[],Gt=[],Hn=[];function Co(v,A){let U=ge.show(n,A);if(U instanceof HTMLElement)return ci(U,Iw),ci(U,v.class),is(U,-10,-10,k,Me),m.insertBefore(U,ft[A]),U}function Sr(v,A){if(s==1||A>0){let U=s==1&&S[v.scale].time,O=v.value;v.value=U?Ug(O)?Gg(H,Vg(O,z)):O||ee:O||XE,v.label=v.label||(U?FE:OE)}if(Ie||A>0){v.width=v.width==null?1:v.width,v.paths=v.paths||r1||Zw,v.fillTo=bt(v.fillTo||JE),v.pxAlign=+At(v.pxAlign,_),v.pxRound=Kg(v.pxAlign),v.stroke=bt(v.stroke||null),v.fill=bt(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let U=qE(Kn(1,v.width),1),O=v.points=_n({},{size:U,width:Kn(1,U*.2),stroke:v.stroke,space:U*2,paths:o1,_stroke:null,_fill:null},v.points);O.show=bt(O.show),O.filter=bt(O.filter),O.fill=bt(O.fill),O.stroke=bt(O.stroke),O.paths=bt(O.paths),O.pxAlign=v.pxAlign}if(q){let U=Z(v,A);Ve.splice(A,0,U[0]),De.splice(A,0,U[1]),j.values.push(null)}if(ue){ie.splice(A,0,null);let U=null;Ie?A==0&&(U=Co(v,A)):A>0&&(U=Co(v,A)),ft.splice(A,0,U),Gt.splice(A,0,0),Hn.splice(A,0,0)}Tn("addSeries",A)}function zh(v,A){A=A??y.length,v=s==1?Yf(v,A,Wg,Zg):Yf(v,A,{},$g),y.splice(A,0,v),Sr(y[A],A)}n.addSeries=zh;function qa(v){if(y.splice(v,1),q){j.values.splice(v,1),De.splice(v,1);let A=Ve.splice(v,1)[0];Ke(null,A.firstChild),A.remove()}ue&&(ie.splice(v,1),ft.splice(v,1)[0].remove(),Gt.splice(v,1),Hn.splice(v,1)),Tn("delSeries",v)}n.delSeries=qa;let Vi=[!1,!1,!1,!1];function ss(v,A){if(v._show=v.show,v.show){let U=v.side%2,O=S[v.scale];O==null&&(v.scale=U?y[1].scale:M,O=S[v.scale]);let X=O.time;v.size=bt(v.size),v.space=bt(v.space),v.rotate=bt(v.rotate),Ks(v.incrs)&&v.incrs.forEach(fe=>{!js.has(fe)&&js.set(fe,h0(fe))}),v.incrs=bt(v.incrs||(O.distr==2?_E:X?p==1?yE:ME:gr)),v.splits=bt(v.splits||(X&&O.distr==1?oe:O.distr==3?Hf:O.distr==4?zE:kE)),v.stroke=bt(v.stroke),v.grid.stroke=bt(v.grid.stroke),v.ticks.stroke=bt(v.ticks.stroke),v.border.stroke=bt(v.border.stroke);let Q=v.values;v.values=Ks(Q)&&!Ks(Q[0])?bt(Q):X?Ks(Q)?zg(H,kg(Q,z)):Ug(Q)?EE(H,Q):Q||Y:Q||BE,v.filter=bt(v.filter||(O.distr>=3&&O.log==10?HE:O.distr==3&&O.log==2?WE:l0)),v.font=t0(v.font),v.labelFont=t0(v.labelFont),v._size=v.size(n,null,A,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Vi[A]=!0,v._el=bi(Aw,h))}}function rs(v,A,U,O){let[X,Q,fe,xe]=U,Te=A%2,Fe=0;return Te==0&&(xe||Q)&&(Fe=A==0&&!X||A==2&&!fe?Mn(Hg.size/3):0),Te==1&&(X||fe)&&(Fe=A==1&&!Q||A==3&&!xe?Mn(qg.size/2):0),Fe}let Ro=n.padding=(i.padding||[rs,rs,rs,rs]).map(v=>bt(At(v,rs))),Ei=n._padding=Ro.map((v,A)=>v(n,A,Vi,0)),tn,an=null,ln=null,Gi=s==1?y[0].idxs:null,ti=null,As=!1;function Po(v,A){if(e=v??[],n.data=n._data=e,s==2){tn=0;for(let U=1;U<y.length;U++)tn+=e[U][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ti=e[0],tn=ti.length;let U=e;if(D==2){U=e.slice();let O=U[0]=Array(tn);for(let X=0;X<tn;X++)O[X]=X}n._data=e=U}if(dt(!0),Tn("setData"),D==2&&(Ee=!0),A!==!1){let U=T;U.auto(n,As)?Io():Ps(M,U.min,U.max),se=se||ne.left>=0,ve=!0,Bn()}}n.setData=Po;function Io(){As=!0;let v,A;s==1&&(tn>0?(an=Gi[0]=0,ln=Gi[1]=tn-1,v=e[0][an],A=e[0][ln],D==2?(v=an,A=ln):v==A&&(D==3?[v,A]=Dh(v,v,T.log,!1):D==4?[v,A]=Kf(v,v,T.log,!1):T.time?A=v+Mn(86400/p):[v,A]=Ph(v,A,jf,!0))):(an=Gi[0]=v=null,ln=Gi[1]=A=null)),Ps(M,v,A)}let Mr,Cs,br,C,W,te,J,K,Re,Le;function Pe(v,A,U,O,X,Q){v??=xg,U??=ed,O??="butt",X??=xg,Q??="round",v!=Mr&&(f.strokeStyle=Mr=v),X!=Cs&&(f.fillStyle=Cs=X),A!=br&&(f.lineWidth=br=A),Q!=W&&(f.lineJoin=W=Q),O!=te&&(f.lineCap=te=O),U!=C&&f.setLineDash(C=U)}function Ne(v,A,U,O){A!=Cs&&(f.fillStyle=Cs=A),v!=J&&(f.font=J=v),U!=K&&(f.textAlign=K=U),O!=Re&&(f.textBaseline=Re=O)}function Ye(v,A,U,O,X=0){if(O.length>0&&v.auto(n,As)&&(A==null||A.min==null)){let Q=At(an,0),fe=At(ln,O.length-1),xe=U.min==null?Hw(O,Q,fe,X,v.distr==3):[U.min,U.max];v.min=ki(v.min,U.min=xe[0]),v.max=Kn(v.max,U.max=xe[1])}}let lt={min:null,max:null};function _t(){for(let O in S){let X=S[O];B[O]==null&&(X.min==null||B[M]!=null&&X.auto(n,As))&&(B[O]=lt)}for(let O in S){let X=S[O];B[O]==null&&X.from!=null&&B[X.from]!=null&&(B[O]=lt)}B[M]!=null&&dt(!0);let v={};for(let O in B){let X=B[O];if(X!=null){let Q=v[O]=bo(S[O],jw);if(X.min!=null)_n(Q,X);else if(O!=M||s==2)if(tn==0&&Q.from==null){let fe=Q.range(n,null,null,O);Q.min=fe[0],Q.max=fe[1]}else Q.min=zt,Q.max=-zt}}if(tn>0){y.forEach((O,X)=>{if(s==1){let Q=O.scale,fe=B[Q];if(fe==null)return;let xe=v[Q];if(X==0){let Te=xe.range(n,xe.min,xe.max,Q);xe.min=Te[0],xe.max=Te[1],an=Bi(xe.min,e[0]),ln=Bi(xe.max,e[0]),ln-an>1&&(e[0][an]<xe.min&&an++,e[0][ln]>xe.max&&ln--),O.min=ti[an],O.max=ti[ln]}else O.show&&O.auto&&Ye(xe,fe,O,e[X],O.sorted);O.idxs[0]=an,O.idxs[1]=ln}else if(X>0&&O.show&&O.auto){let[Q,fe]=O.facets,xe=Q.scale,Te=fe.scale,[Fe,ze]=e[X],He=v[xe],ut=v[Te];He!=null&&Ye(He,B[xe],Q,Fe,Q.sorted),ut!=null&&Ye(ut,B[Te],fe,ze,fe.sorted),O.min=fe.min,O.max=fe.max}});for(let O in v){let X=v[O],Q=B[O];if(X.from==null&&(Q==null||Q.min==null)){let fe=X.range(n,X.min==zt?null:X.min,X.max==-zt?null:X.max,O);X.min=fe[0],X.max=fe[1]}}}for(let O in v){let X=v[O];if(X.from!=null){let Q=v[X.from];if(Q.min==null)X.min=X.max=null;else{let fe=X.range(n,Q.min,Q.max,O);X.min=fe[0],X.max=fe[1]}}}let A={},U=!1;for(let O in v){let X=v[O],Q=S[O];if(Q.min!=X.min||Q.max!=X.max){Q.min=X.min,Q.max=X.max;let fe=Q.distr;Q._min=fe==3?ws(Q.min):fe==4?Nf(Q.min,Q.asinh):fe==100?Q.fwd(Q.min):Q.min,Q._max=fe==3?ws(Q.max):fe==4?Nf(Q.max,Q.asinh):fe==100?Q.fwd(Q.max):Q.max,A[O]=U=!0}}if(U){y.forEach((O,X)=>{s==2?X>0&&A.y&&(O._paths=null):A[O.scale]&&(O._paths=null)});for(let O in A)Ee=!0,Tn("setScale",O);ue&&ne.left>=0&&(se=ve=!0)}for(let O in B)B[O]=null}function qe(v){let A=Gf(an-1,0,tn-1),U=Gf(ln+1,0,tn-1);for(;v[A]==null&&A>0;)A--;for(;v[U]==null&&U<tn-1;)U++;return[A,U]}function xt(){if(tn>0){let v=y.some(A=>A._focus)&&Le!=Xe.alpha;v&&(f.globalAlpha=Le=Xe.alpha),y.forEach((A,U)=>{if(U>0&&A.show&&(jt(U,!1),jt(U,!0),A._paths==null)){let O=Le;Le!=A.alpha&&(f.globalAlpha=Le=A.alpha);let X=s==2?[0,e[U][0].length-1]:qe(e[U]);A._paths=A.paths(n,U,X[0],X[1]),Le!=O&&(f.globalAlpha=Le=O)}}),y.forEach((A,U)=>{if(U>0&&A.show){let O=Le;Le!=A.alpha&&(f.globalAlpha=Le=A.alpha),A._paths!=null&&Nt(U,!1);{let X=A._paths!=null?A._paths.gaps:null,Q=A.points.show(n,U,an,ln,X),fe=A.points.filter(n,U,Q,X);(Q||fe)&&(A.points._paths=A.points.paths(n,U,an,ln,fe),Nt(U,!0))}Le!=O&&(f.globalAlpha=Le=O),Tn("drawSeries",U)}}),v&&(f.globalAlpha=Le=1)}}function jt(v,A){let U=A?y[v].points:y[v];U._stroke=U.stroke(n,v),U._fill=U.fill(n,v)}function Nt(v,A){let U=A?y[v].points:y[v],{stroke:O,fill:X,clip:Q,flags:fe,_stroke:xe=U._stroke,_fill:Te=U._fill,_width:Fe=U.width}=U._paths;Fe=Vt(Fe*Pt,3);let ze=null,He=Fe%2/2;A&&Te==null&&(Te=Fe>0?"#fff":xe);let ut=U.pxAlign==1&&He>0;if(ut&&f.translate(He,He),!A){let Ct=N-Fe/2,Tt=E-Fe/2,vt=$+Fe,st=_e+Fe;ze=new Path2D,ze.rect(Ct,Tt,vt,st)}A?Ge(xe,Fe,U.dash,U.cap,Te,O,X,fe,Q):Ut(v,xe,Fe,U.dash,U.cap,Te,O,X,fe,ze,Q),ut&&f.translate(-He,-He)}function Ut(v,A,U,O,X,Q,fe,xe,Te,Fe,ze){let He=!1;Te!=0&&b.forEach((ut,Ct)=>{if(ut.series[0]==v){let Tt=y[ut.series[1]],vt=e[ut.series[1]],st=(Tt._paths||Wa).band;Ks(st)&&(st=ut.dir==1?st[0]:st[1]);let je,Xt=null;Tt.show&&st&&Xw(vt,an,ln)?(Xt=ut.fill(n,Ct)||Q,je=Tt._paths.clip):st=null,Ge(A,U,O,X,Xt,fe,xe,Te,Fe,ze,je,st),He=!0}}),He||Ge(A,U,O,X,Q,fe,xe,Te,Fe,ze)}let xn=wo|Xf;function Ge(v,A,U,O,X,Q,fe,xe,Te,Fe,ze,He){Pe(v,A,U,O,X),(Te||Fe||He)&&(f.save(),Te&&f.clip(Te),Fe&&f.clip(Fe)),He?(xe&xn)==xn?(f.clip(He),ze&&f.clip(ze),St(X,fe),hn(v,Q,A)):xe&Xf?(St(X,fe),f.clip(He),hn(v,Q,A)):xe&wo&&(f.save(),f.clip(He),ze&&f.clip(ze),St(X,fe),f.restore(),hn(v,Q,A)):(St(X,fe),hn(v,Q,A)),(Te||Fe||He)&&f.restore()}function hn(v,A,U){U>0&&(A instanceof Map?A.forEach((O,X)=>{f.strokeStyle=Mr=X,f.stroke(O)}):A!=null&&v&&f.stroke(A))}function St(v,A){A instanceof Map?A.forEach((U,O)=>{f.fillStyle=Cs=O,f.fill(U)}):A!=null&&v&&f.fill(A)}function os(v,A,U,O){let X=R[v],Q;if(O<=0)Q=[0,0];else{let fe=X._space=X.space(n,v,A,U,O),xe=X._incrs=X.incrs(n,v,A,U,O,fe);Q=f1(A,U,xe,O,fe)}return X._found=Q}function un(v,A,U,O,X,Q,fe,xe,Te,Fe){let ze=fe%2/2;_==1&&f.translate(ze,ze),Pe(xe,fe,Te,Fe,xe),f.beginPath();let He,ut,Ct,Tt,vt=X+(O==0||O==3?-Q:Q);U==0?(ut=X,Tt=vt):(He=X,Ct=vt);for(let st=0;st<v.length;st++)A[st]!=null&&(U==0?He=Ct=v[st]:ut=Tt=v[st],f.moveTo(He,ut),f.lineTo(Ct,Tt));f.stroke(),_==1&&f.translate(-ze,-ze)}function wr(v){let A=!0;return R.forEach((U,O)=>{if(!U.show)return;let X=S[U.scale];if(X.min==null){U._show&&(A=!1,U._show=!1,dt(!1));return}else U._show||(A=!1,U._show=!0,dt(!1));let Q=U.side,fe=Q%2,{min:xe,max:Te}=X,[Fe,ze]=os(O,xe,Te,fe==0?k:Me);if(ze==0)return;let He=X.distr==2,ut=U._splits=U.splits(n,O,xe,Te,Fe,ze,He),Ct=X.distr==2?ut.map(je=>ti[je]):ut,Tt=X.distr==2?ti[ut[1]]-ti[ut[0]]:Fe,vt=U._values=U.values(n,U.filter(n,Ct,O,ze,Tt),O,ze,Tt);U._rotate=Q==2?U.rotate(n,vt,O,ze):0;let st=U._size;U._size=wi(U.size(n,vt,O,v)),st!=null&&U._size!=st&&(A=!1)}),A}function Hi(v){let A=!0;return Ro.forEach((U,O)=>{let X=U(n,O,Vi,v);X!=Ei[O]&&(A=!1),Ei[O]=X}),A}function as(){for(let v=0;v<R.length;v++){let A=R[v];if(!A.show||!A._show)continue;let U=A.side,O=U%2,X,Q,fe=A.stroke(n,v),xe=U==0||U==3?-1:1,[Te,Fe]=A._found;if(A.label!=null){let qn=A.labelGap*xe,si=Mn((A._lpos+qn)*Pt);Ne(A.labelFont[0],fe,"center",U==2?"top":_g),f.save(),O==1?(X=Q=0,f.translate(si,Mn(E+_e/2)),f.rotate((U==3?-Ch:Ch)/2)):(X=Mn(N+$/2),Q=si);let tr=o0(A.label)?A.label(n,v,Te,Fe):A.label;f.fillText(tr,X,Q),f.restore()}if(Fe==0)continue;let ze=S[A.scale],He=O==0?$:_e,ut=O==0?N:E,Ct=A._splits,Tt=ze.distr==2?Ct.map(qn=>ti[qn]):Ct,vt=ze.distr==2?ti[Ct[1]]-ti[Ct[0]]:Te,st=A.ticks,je=A.border,Xt=st.show?st.size:0,sn=Mn(Xt*Pt),An=Mn((A.alignTo==2?A._size-Xt-A.gap:A.gap)*Pt),Ft=A._rotate*-Ch/180,rn=g(A._pos*Pt),ni=(sn+An)*xe,Xn=rn+ni;Q=O==0?Xn:0,X=O==1?Xn:0;let fi=A.font[0],Ti=A.align==1?xo:A.align==2?If:Ft>0?xo:Ft<0?If:O==0?"center":U==3?If:xo,qi=Ft||O==1?"middle":U==2?"top":_g;Ne(fi,fe,Ti,qi);let ii=A.font[1]*A.lineGap,di=Ct.map(qn=>g(a(qn,ze,He,ut))),Ai=A._values;for(let qn=0;qn<Ai.length;qn++){let si=Ai[qn];if(si!=null){O==0?X=di[qn]:Q=di[qn],si=""+si;let tr=si.indexOf(`
`)==-1?[si]:si.split(/\n/gm);for(let Yn=0;Yn<tr.length;Yn++){let Cd=tr[Yn];Ft?(f.save(),f.translate(X,Q+Yn*ii),f.rotate(Ft),f.fillText(Cd,0,0),f.restore()):f.fillText(Cd,X,Q+Yn*ii)}}}st.show&&un(di,st.filter(n,Tt,v,Fe,vt),O,U,rn,sn,Vt(st.width*Pt,3),st.stroke(n,v),st.dash,st.cap);let Yi=A.grid;Yi.show&&un(di,Yi.filter(n,Tt,v,Fe,vt),O,O==0?2:1,O==0?E:N,O==0?_e:$,Vt(Yi.width*Pt,3),Yi.stroke(n,v),Yi.dash,Yi.cap),je.show&&un([rn],[1],O==0?1:0,O==0?1:2,O==1?E:N,O==1?_e:$,Vt(je.width*Pt,3),je.stroke(n,v),je.dash,je.cap)}Tn("drawAxes")}function dt(v){y.forEach((A,U)=>{U>0&&(A._paths=null,v&&(s==1?(A.min=null,A.max=null):A.facets.forEach(O=>{O.min=null,O.max=null})))})}let nn=!1,Wn=!1,Ot=[];function fn(){Wn=!1;for(let v=0;v<Ot.length;v++)Tn(...Ot[v]);Ot.length=0}function Bn(){nn||(rE(hd),nn=!0)}function Ya(v,A=!1){nn=!0,Wn=A,v(n),hd(),A&&Ot.length>0&&queueMicrotask(fn)}n.batch=Ya;function hd(){if(he&&(_t(),he=!1),Ee&&(Ce(),Ee=!1),we){if($t(d,xo,$e),$t(d,"top",We),$t(d,za,k),$t(d,Va,Me),$t(m,xo,$e),$t(m,"top",We),$t(m,za,k),$t(m,Va,Me),$t(h,za,it),$t(h,Va,gt),u.width=Mn(it*Pt),u.height=Mn(gt*Pt),R.forEach(({_el:v,_show:A,_size:U,_pos:O,side:X})=>{if(v!=null)if(A){let Q=X===3||X===0?U:0,fe=X%2==1;$t(v,fe?"left":"top",O-Q),$t(v,fe?"width":"height",U),$t(v,fe?"top":"left",fe?We:$e),$t(v,fe?"height":"width",fe?Me:k),zf(v,_r)}else ci(v,_r)}),Mr=Cs=br=W=te=J=K=Re=C=null,Le=1,No(!0),$e!=ye||We!=mt||k!=ke||Me!=et){dt(!1);let v=k/ke,A=Me/et;if(ue&&!se&&ne.left>=0){ne.left*=v,ne.top*=A,Er&&is(Er,Mn(ne.left),0,k,Me),Tr&&is(Tr,0,Mn(ne.top),k,Me);for(let U=0;U<ft.length;U++){let O=ft[U];O!=null&&(Gt[U]*=v,Hn[U]*=A,is(O,wi(Gt[U]),wi(Hn[U]),k,Me))}}if(Wt.show&&!ae&&Wt.left>=0&&Wt.width>0){Wt.left*=v,Wt.width*=v,Wt.top*=A,Wt.height*=A;for(let U in qh)$t(Rr,U,Wt[U])}ye=$e,mt=We,ke=k,et=Me}Tn("setSize"),we=!1}it>0&&gt>0&&(f.clearRect(0,0,u.width,u.height),Tn("drawClear"),w.forEach(v=>v()),Tn("draw")),Wt.show&&ae&&($a(Wt),ae=!1),ue&&se&&(er(null,!0,!1),se=!1),j.show&&j.live&&ve&&(Wh(),ve=!1),l||(l=!0,n.status=1,Tn("ready")),As=!1,nn=!1}n.redraw=(v,A)=>{Ee=A||!1,v!==!1?Ps(M,T.min,T.max):Bn()};function Vh(v,A){let U=S[v];if(U.from==null){if(tn==0){let O=U.range(n,A.min,A.max,v);A.min=O[0],A.max=O[1]}if(A.min>A.max){let O=A.min;A.min=A.max,A.max=O}if(tn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;v==M&&U.distr==2&&tn>0&&(A.min=Bi(A.min,e[0]),A.max=Bi(A.max,e[0]),A.min==A.max&&A.max++),B[v]=A,he=!0,Bn()}}n.setScale=Vh;let Gh,Hh,Er,Tr,ud,fd,Ar,Cr,dd,pd,Ht,Zt,Rs=!1,Ln=ne.drag,wn=Ln.x,En=Ln.y;ue&&(ne.x&&(Gh=bi(Rw,m)),ne.y&&(Hh=bi(Pw,m)),T.ori==0?(Er=Gh,Tr=Hh):(Er=Hh,Tr=Gh),Ht=ne.left,Zt=ne.top);let Wt=n.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Rr=Wt.show?bi(Cw,Wt.over?m:d):null;function $a(v,A){if(Wt.show){for(let U in v)Wt[U]=v[U],U in qh&&$t(Rr,U,v[U]);A!==!1&&Tn("setSelect")}}n.setSelect=$a;function Y0(v){if(y[v].show)q&&zf(Ve[v],_r);else if(q&&ci(Ve[v],_r),ue){let U=Ie?ft[0]:ft[v];U!=null&&is(U,-10,-10,k,Me)}}function Ps(v,A,U){Vh(v,{min:A,max:U})}function Wi(v,A,U,O){A.focus!=null&&j0(v),A.show!=null&&y.forEach((X,Q)=>{Q>0&&(v==Q||v==null)&&(X.show=A.show,Y0(Q),s==2?(Ps(X.facets[0].scale,null,null),Ps(X.facets[1].scale,null,null)):Ps(X.scale,null,null),Bn())}),U!==!1&&Tn("setSeries",v,A),O&&Uo("setSeries",n,v,A)}n.setSeries=Wi;function $0(v,A){_n(b[v],A)}function Z0(v,A){v.fill=bt(v.fill||null),v.dir=At(v.dir,-1),A=A??b.length,b.splice(A,0,v)}function J0(v){v==null?b.length=0:b.splice(v,1)}n.addBand=Z0,n.setBand=$0,n.delBand=J0;function K0(v,A){y[v].alpha=A,ue&&ft[v]!=null&&(ft[v].style.opacity=A),q&&Ve[v]&&(Ve[v].style.opacity=A)}let ls,Is,Qs,Pr={focus:!0};function j0(v){if(v!=Qs){let A=v==null,U=Xe.alpha!=1;y.forEach((O,X)=>{if(s==1||X>0){let Q=A||X==0||X==v;O._focus=A?null:Q,U&&K0(X,Q?1:Xe.alpha)}}),Qs=v,U&&Bn()}}q&&at&&Se(Sg,pe,v=>{ne._lock||(ot(v),Qs!=null&&Wi(null,Pr,!0,dn.setSeries))});function Xi(v,A,U){let O=S[A];U&&(v=v/Pt-(O.ori==1?We:$e));let X=k;O.ori==1&&(X=Me,v=X-v),O.dir==-1&&(v=X-v);let Q=O._min,fe=O._max,xe=v/X,Te=Q+(fe-Q)*xe,Fe=O.distr;return Fe==3?So(10,Te):Fe==4?Yw(Te,O.asinh):Fe==100?O.bwd(Te):Te}function Q0(v,A){let U=Xi(v,M,A);return Bi(U,e[0],an,ln)}n.valToIdx=v=>Bi(v,e[0]),n.posToIdx=Q0,n.posToVal=Xi,n.valToPos=(v,A,U)=>S[A].ori==0?r(v,S[A],U?$:k,U?N:0):o(v,S[A],U?_e:Me,U?E:0),n.setCursor=(v,A,U)=>{Ht=v.left,Zt=v.top,er(null,A,U)};function md(v,A){$t(Rr,xo,Wt.left=v),$t(Rr,za,Wt.width=A)}function gd(v,A){$t(Rr,"top",Wt.top=v),$t(Rr,Va,Wt.height=A)}let Lo=T.ori==0?md:gd,Do=T.ori==1?md:gd;function e_(){if(q&&j.live)for(let v=s==2?1:0;v<y.length;v++){if(v==0&&tt)continue;let A=j.values[v],U=0;for(let O in A)De[v][U++].firstChild.nodeValue=A[O]}}function Wh(v,A){if(v!=null&&(v.idxs?v.idxs.forEach((U,O)=>{ie[O]=U}):Kw(v.idx)||ie.fill(v.idx),j.idx=ie[0]),q&&j.live){for(let U=0;U<y.length;U++)(U>0||s==1&&!tt)&&t_(U,ie[U]);e_()}ve=!1,A!==!1&&Tn("setLegend")}n.setLegend=Wh;function t_(v,A){let U=y[v],O=v==0&&D==2?ti:e[v],X;tt?X=U.values(n,v,A)??Be:(X=U.value(n,A==null?null:O[A],v,A),X=X==null?Be:{_:X}),j.values[v]=X}function er(v,A,U){dd=Ht,pd=Zt,[Ht,Zt]=ne.move(n,Ht,Zt),ne.left=Ht,ne.top=Zt,ue&&(Er&&is(Er,Mn(Ht),0,k,Me),Tr&&is(Tr,0,Mn(Zt),k,Me));let O,X=an>ln;ls=zt,Is=null;let Q=T.ori==0?k:Me,fe=T.ori==1?k:Me;if(Ht<0||tn==0||X){O=ne.idx=null;for(let xe=0;xe<y.length;xe++){let Te=ft[xe];Te!=null&&is(Te,-10,-10,k,Me)}at&&Wi(null,Pr,!0,v==null&&dn.setSeries),j.live&&(ie.fill(O),ve=!0)}else{let xe,Te,Fe;s==1&&(xe=T.ori==0?Ht:Zt,Te=Xi(xe,M),O=ne.idx=Bi(Te,e[0],an,ln),Fe=L(e[0][O],T,Q,0));let ze=-10,He=-10,ut=0,Ct=0,Tt=!0,vt="",st="";for(let je=s==2?1:0;je<y.length;je++){let Xt=y[je],sn=ie[je],An=sn==null?null:s==1?e[je][sn]:e[je][1][sn],Ft=ne.dataIdx(n,je,O,Te),rn=Ft==null?null:s==1?e[je][Ft]:e[je][1][Ft];if(ve=ve||rn!=An||Ft!=sn,ie[je]=Ft,je>0&&Xt.show){let ni=Ft==null?-10:Ft==O?Fe:L(s==1?e[0][Ft]:e[je][0][Ft],T,Q,0),Xn=rn==null?-10:P(rn,s==1?S[Xt.scale]:S[Xt.facets[1].scale],fe,0);if(at&&rn!=null){let fi=T.ori==1?Ht:Zt,Ti=bn(Xe.dist(n,je,Ft,Xn,fi));if(Ti<ls){let qi=Xe.bias;if(qi!=0){let ii=Xi(fi,Xt.scale),di=rn>=0?1:-1,Ai=ii>=0?1:-1;Ai==di&&(Ai==1?qi==1?rn>=ii:rn<=ii:qi==1?rn<=ii:rn>=ii)&&(ls=Ti,Is=je)}else ls=Ti,Is=je}}if(ve||Ie){let fi,Ti;T.ori==0?(fi=ni,Ti=Xn):(fi=Xn,Ti=ni);let qi,ii,di,Ai,Yi,qn,si=!0,tr=ge.bbox;if(tr!=null){si=!1;let Yn=tr(n,je);di=Yn.left,Ai=Yn.top,qi=Yn.width,ii=Yn.height}else di=fi,Ai=Ti,qi=ii=ge.size(n,je);if(qn=ge.fill(n,je),Yi=ge.stroke(n,je),Ie)je==Is&&ls<=Xe.prox&&(ze=di,He=Ai,ut=qi,Ct=ii,Tt=si,vt=qn,st=Yi);else{let Yn=ft[je];Yn!=null&&(Gt[je]=di,Hn[je]=Ai,Cg(Yn,qi,ii,si),Tg(Yn,qn,Yi),is(Yn,wi(di),wi(Ai),k,Me))}}}}if(Ie){let je=Xe.prox,Xt=Qs==null?ls<=je:ls>je||Is!=Qs;if(ve||Xt){let sn=ft[0];sn!=null&&(Gt[0]=ze,Hn[0]=He,Cg(sn,ut,Ct,Tt),Tg(sn,vt,st),is(sn,wi(ze),wi(He),k,Me))}}}if(Wt.show&&Rs)if(v!=null){let[xe,Te]=dn.scales,[Fe,ze]=dn.match,[He,ut]=v.cursor.sync.scales,Ct=v.cursor.drag;if(wn=Ct._x,En=Ct._y,wn||En){let{left:Tt,top:vt,width:st,height:je}=v.select,Xt=v.scales[He].ori,sn=v.posToVal,An,Ft,rn,ni,Xn,fi=xe!=null&&Fe(xe,He),Ti=Te!=null&&ze(Te,ut);fi&&wn?(Xt==0?(An=Tt,Ft=st):(An=vt,Ft=je),rn=S[xe],ni=L(sn(An,He),rn,Q,0),Xn=L(sn(An+Ft,He),rn,Q,0),Lo(ki(ni,Xn),bn(Xn-ni))):Lo(0,Q),Ti&&En?(Xt==1?(An=Tt,Ft=st):(An=vt,Ft=je),rn=S[Te],ni=P(sn(An,ut),rn,fe,0),Xn=P(sn(An+Ft,ut),rn,fe,0),Do(ki(ni,Xn),bn(Xn-ni))):Do(0,fe)}else Yh()}else{let xe=bn(dd-ud),Te=bn(pd-fd);if(T.ori==1){let ut=xe;xe=Te,Te=ut}wn=Ln.x&&xe>=Ln.dist,En=Ln.y&&Te>=Ln.dist;let Fe=Ln.uni;Fe!=null?wn&&En&&(wn=xe>=Fe,En=Te>=Fe,!wn&&!En&&(Te>xe?En=!0:wn=!0)):Ln.x&&Ln.y&&(wn||En)&&(wn=En=!0);let ze,He;wn&&(T.ori==0?(ze=Ar,He=Ht):(ze=Cr,He=Zt),Lo(ki(ze,He),bn(He-ze)),En||Do(0,fe)),En&&(T.ori==1?(ze=Ar,He=Ht):(ze=Cr,He=Zt),Do(ki(ze,He),bn(He-ze)),wn||Lo(0,Q)),!wn&&!En&&(Lo(0,0),Do(0,0))}if(Ln._x=wn,Ln._y=En,v==null){if(U){if(Ad!=null){let[xe,Te]=dn.scales;dn.values[0]=xe!=null?Xi(T.ori==0?Ht:Zt,xe):null,dn.values[1]=Te!=null?Xi(T.ori==1?Ht:Zt,Te):null}Uo(Lf,n,Ht,Zt,k,Me,O)}if(at){let xe=U&&dn.setSeries,Te=Xe.prox;Qs==null?ls<=Te&&Wi(Is,Pr,!0,xe):ls>Te?Wi(null,Pr,!0,xe):Is!=Qs&&Wi(Is,Pr,!0,xe)}}ve&&(j.idx=O,Wh()),A!==!1&&Tn("setCursor")}let Ls=null;Object.defineProperty(n,"rect",{get(){return Ls==null&&No(!1),Ls}});function No(v=!1){v?Ls=null:(Ls=m.getBoundingClientRect(),Tn("syncRect",Ls))}function _d(v,A,U,O,X,Q,fe){ne._lock||Rs&&v!=null&&v.movementX==0&&v.movementY==0||(Xh(v,A,U,O,X,Q,fe,!1,v!=null),v!=null?er(null,!0,!0):er(A,!0,!1))}function Xh(v,A,U,O,X,Q,fe,xe,Te){if(Ls==null&&No(!1),ot(v),v!=null)U=v.clientX-Ls.left,O=v.clientY-Ls.top;else{if(U<0||O<0){Ht=-10,Zt=-10;return}let[Fe,ze]=dn.scales,He=A.cursor.sync,[ut,Ct]=He.values,[Tt,vt]=He.scales,[st,je]=dn.match,Xt=A.axes[0].side%2==1,sn=T.ori==0?k:Me,An=T.ori==1?k:Me,Ft=Xt?Q:X,rn=Xt?X:Q,ni=Xt?O:U,Xn=Xt?U:O;if(Tt!=null?U=st(Fe,Tt)?a(ut,S[Fe],sn,0):-10:U=sn*(ni/Ft),vt!=null?O=je(ze,vt)?a(Ct,S[ze],An,0):-10:O=An*(Xn/rn),T.ori==1){let fi=U;U=O,O=fi}}Te&&(A==null||A.cursor.event.type==Lf)&&((U<=1||U>=k-1)&&(U=mr(U,k)),(O<=1||O>=Me-1)&&(O=mr(O,Me))),xe?(ud=U,fd=O,[Ar,Cr]=ne.move(n,U,O)):(Ht=U,Zt=O)}let qh={width:0,height:0,left:0,top:0};function Yh(){$a(qh,!1)}let xd,yd,vd,Sd;function Md(v,A,U,O,X,Q,fe){Rs=!0,wn=En=Ln._x=Ln._y=!1,Xh(v,A,U,O,X,Q,fe,!0,!1),v!=null&&(Se(Df,Bf,bd,!1),Uo(yg,n,Ar,Cr,k,Me,null));let{left:xe,top:Te,width:Fe,height:ze}=Wt;xd=xe,yd=Te,vd=Fe,Sd=ze}function bd(v,A,U,O,X,Q,fe){Rs=Ln._x=Ln._y=!1,Xh(v,A,U,O,X,Q,fe,!1,!0);let{left:xe,top:Te,width:Fe,height:ze}=Wt,He=Fe>0||ze>0,ut=xd!=xe||yd!=Te||vd!=Fe||Sd!=ze;if(He&&ut&&$a(Wt),Ln.setScale&&He&&ut){let Ct=xe,Tt=Fe,vt=Te,st=ze;if(T.ori==1&&(Ct=Te,Tt=ze,vt=xe,st=Fe),wn&&Ps(M,Xi(Ct,M),Xi(Ct+Tt,M)),En)for(let je in S){let Xt=S[je];je!=M&&Xt.from==null&&Xt.min!=zt&&Ps(je,Xi(vt+st,je),Xi(vt,je))}Yh()}else ne.lock&&(ne._lock=!ne._lock,er(A,!0,v!=null));v!=null&&(Ke(Df,Bf),Uo(Df,n,Ht,Zt,k,Me,null))}function n_(v,A,U,O,X,Q,fe){if(ne._lock)return;ot(v);let xe=Rs;if(Rs){let Te=!0,Fe=!0,ze=10,He,ut;T.ori==0?(He=wn,ut=En):(He=En,ut=wn),He&&ut&&(Te=Ht<=ze||Ht>=k-ze,Fe=Zt<=ze||Zt>=Me-ze),He&&Te&&(Ht=Ht<Ar?0:k),ut&&Fe&&(Zt=Zt<Cr?0:Me),er(null,!0,!0),Rs=!1}Ht=-10,Zt=-10,ie.fill(null),er(null,!0,!0),xe&&(Rs=xe)}function wd(v,A,U,O,X,Q,fe){ne._lock||(ot(v),Io(),Yh(),v!=null&&Uo(Mg,n,Ht,Zt,k,Me,null))}function Ed(){R.forEach(d1),V(n.width,n.height,!0)}xr(Rh,vo,Ed);let Ir={};Ir.mousedown=Md,Ir.mousemove=_d,Ir.mouseup=bd,Ir.dblclick=wd,Ir.setSeries=(v,A,U,O)=>{let X=dn.match[2];U=X(n,A,U),U!=-1&&Wi(U,O,!0,!1)},ue&&(Se(yg,m,Md),Se(Lf,m,_d),Se(vg,m,v=>{ot(v),No(!1)}),Se(Sg,m,n_),Se(Mg,m,wd),qf.add(n),n.syncRect=No);let Za=n.hooks=i.hooks||{};function Tn(v,A,U){Wn?Ot.push([v,A,U]):v in Za&&Za[v].forEach(O=>{O.call(null,n,A,U)})}(i.plugins||[]).forEach(v=>{for(let A in v.hooks)Za[A]=(Za[A]||[]).concat(v.hooks[A])});let Td=(v,A,U)=>U,dn=_n({key:null,setSeries:!1,filters:{pub:Dg,sub:Dg},scales:[M,y[1]?y[1].scale:null],match:[Ng,Ng,Td],values:[null,null]},ne.sync);dn.match.length==2&&dn.match.push(Td),ne.sync=dn;let Ad=dn.key,$h=P0(Ad);function Uo(v,A,U,O,X,Q,fe){dn.filters.pub(v,A,U,O,X,Q,fe)&&$h.pub(v,A,U,O,X,Q,fe)}$h.sub(n);function i_(v,A,U,O,X,Q,fe){dn.filters.sub(v,A,U,O,X,Q,fe)&&Ir[v](null,A,U,O,X,Q,fe)}n.pub=i_;function s_(){$h.unsub(n),qf.delete(n),me.clear(),Vf(Rh,vo,Ed),c.remove(),pe?.remove(),Tn("destroy")}n.destroy=s_;function Zh(){Tn("init",i,e),Po(e||i.data,!1),B[M]?Vh(M,B[M]):Io(),ae=Wt.show&&(Wt.width>0||Wt.height>0),se=ve=!0,V(i.width,i.height)}return y.forEach(Sr),R.forEach(ss),t?t instanceof HTMLElement?(t.appendChild(c),Zh()):t(n,Zh):Zh(),n}Fn.assign=_n;Fn.fmtNum=Qf;Fn.rangeNum=Ph;Fn.rangeLog=Dh;Fn.rangeAsinh=Kf;Fn.orient=vr;Fn.pxRatio=Pt;Fn.join=sE;Fn.fmtDate=td,Fn.tzDate=mE;Fn.sync=P0;{Fn.addGap=KE,Fn.clipGaps=Oh;let i=Fn.paths={points:O0};i.linear=B0,i.stepped=e1,i.bars=t1,i.spline=i1}var ld=30,p1=200,zi=16384,G0=["#b3261e","#2e7d32","#1652b8","#e07a5f","#66a182","#7aa5e8","#7a1811","#14532d","#0b2e6b","#444","#888","#d81b9a"];function H0(i){let e=Array.from({length:i+1},()=>new Float64Array(zi)),[t,n]=[0,0];function s(o,a){let l=e[0][(n+zi-1)%zi];t&&(o<l||o-l>ld)&&(t=0),e[0][n]=o;for(let c=0;c<i;c++)e[c+1][n]=a[c];n=(n+1)%zi,t=Math.min(t+1,zi)}function r(o){if(!t)return[[],...o.map(()=>[])];let a=e[0][(n+zi-1)%zi],l=0;for(;l<t&&a-e[0][(n+zi-1-l)%zi]<=ld;)l+=1;let c=n-l+zi,u=(h,d)=>Array.from({length:l},(m,_)=>d(h[(c+_)%zi])),f=h=>Number.isNaN(h)?null:h;return[u(e[0],h=>h-a),...o.map(h=>u(e[h+1],f))]}return{push:s,last:r}}function W0(i,e,t){let n={font:"11px system-ui",size:34,stroke:"#555",grid:{stroke:"#e8e8e2"}},s=e.map((a,l)=>({label:a,stroke:G0[l%G0.length],width:1,points:{show:!1}})),r={width:i.clientWidth||420,height:t,cursor:{show:!1},scales:{x:{time:!1,range:[-ld,0]}},axes:[n,{...n,size:48}],series:[{label:"s"},...s]},o=new Fn(r,[[],...e.map(()=>[])],i);return new ResizeObserver(()=>o.setSize({width:i.clientWidth,height:t})).observe(i),o}function X0(i,e,t){let n=H0(e.length),s=H0(t.length),r=W0(i("forces"),t.map(h=>`face ${h}`),130);i("face").append(...t.map(h=>new Option(h,h)));let o,a;function l(){let h=i("face").value;o=e.flatMap((d,m)=>d.startsWith(`F${h}-`)?[m]:[]),a?.destroy(),i("channels").replaceChildren(),a=W0(i("channels"),o.map(d=>e[d].slice(3)),170)}i("face").addEventListener("change",l),l();function c({rows:h,wide:d,values:m,timeS:_,contacts:g}){for(let p=0;p<h;p++){let y=p*d;n.push(_+m[y],m.subarray(y+1,y+d))}s.push(_,t.map(p=>g.reduce((y,R)=>R.face===p?y+R.force:y,0)))}let u=0;function f(h){h-u<p1||(u=h,a.setData(n.last(o)),r.setData(s.last(t.map((d,m)=>m))))}return{take:c,draw:f}}var cd=["good","absent","silent","saturated","dead","noisy","drifting"],m1=1e3,g1=100;async function _1(){let i=b=>document.querySelector(`[data-name="${b}"]`),e=await fetch(`/scene${location.search}`);if(!e.ok)throw new Error(`the server refused the scene (${e.status})`);let t=await Ds(new Uint8Array(await e.arrayBuffer())),{content:n}=t,{channels:s}=n.live;i("name").textContent=`${n.name}, live`,document.title=`${n.name}, live`,i("key").textContent=n.live.key;let r=ns(i("canvas"),n.size_mm),o=_h(t,r);r.scene.add(o.root);let a=ih(r,i("overlay"),o.silicone.front.geometry),l=n.faces.map(b=>b.number),c=X0(i,s,l),u=M1(i("health"),s);o.fade(Number(i("opacity").value)/100),i("opacity").addEventListener("input",()=>o.fade(Number(i("opacity").value)/100));let f=pg(),h,d,m,_={},g=0;function p(b){if(requestAnimationFrame(p),m&&f.seen(m),m=null,!d)return;let M=performance.now();a.show(d.contacts,d.labels),b-g>=g1&&(v1(i("contacts"),d.contacts),g=b),c.draw(b),h.readyState===WebSocket.OPEN&&h.send(Uint32Array.of(d.number)),[m,d]=[d,null],f.drawn(performance.now()-M)}function y({data:b}){let M=mg(b,s.length);if(M.state)return R(_=M.state);f.came(M),c.take(M),d=M}function R(b){u.show(b.health??[]),S1(i("grasps"),b.grasps??[]);let{recording:M}=b;i("record").setAttribute("aria-pressed",String(!!M?.on)),i("record").textContent=M?.on?"recording":"record",i("record").title=M?.file?`into ${M.file}`:"",i("zero").textContent=b.zeroed?"zero":"zeroing \u2026";let x=[b.told,b.trouble,b.explained===!1?"no contact that the model knows explains these readings":""].filter(Boolean).join("; ");i("trouble").textContent!==x&&(i("trouble").textContent=x),i("told").textContent=y1(b,f.told())}function S(){h=new WebSocket(`ws://${location.host}/stream${location.search}`),h.binaryType="arraybuffer",h.onmessage=y,h.onclose=()=>{i("told").textContent="the server does not answer; what was recorded is kept",setTimeout(S,m1)}}i("zero").addEventListener("click",()=>h.send("zero")),i("record").addEventListener("click",()=>h.send(_.recording?.on?"record off":"record on")),requestAnimationFrame(p),S(),window.instobjLive={figures:()=>({...f.told(),objectDrawn:r.drawn()}),forget:f.forget,state:()=>_,contacts:a.shown,labels:a.told,hidden:a.hidden,pictureMs:()=>x1(r)},document.getElementById("instobj-live").dataset.ready="yes"}function x1(i){let e=i.renderer.getContext(),t=performance.now();return i.draw(),e.readPixels(0,0,1,1,e.RGBA,e.UNSIGNED_BYTE,new Uint8Array(4)),performance.now()-t}function y1(i,e){let{recording:t,counted:n}=i,s=[i.source,`${Ts(i.rate_hz,0)} frames/s`];return n&&s.push(`${n.lost} lost, ${n.damaged} damaged lines, ${n.restarts} restarts`),t&&s.push(t.on||t.rows?`${t.rows} rows in ${t.file}${t.unlabelled?`, ${t.unlabelled} frames without a force not written`:""}`:"not recording"),s.push(`${Ts(e.perSecond,0)} pictures/s, ${Ts(e.latencyMs.p50,0)} ms old (99 %: ${Ts(e.latencyMs.p99,0)})`),e.dropped&&s.push(`${e.dropped} frames not shown here`),s.filter(Boolean).join(" \xB7 ")}var Ts=(i,e)=>Number.isFinite(i)?i.toFixed(e):"\u2013";function v1(i,e){i.replaceChildren(...e.map(t=>{let n=document.createElement("tr");return[t.face,Ts(t.x,1),Ts(t.y,1),Ts(t.radius,1),`${Ts(t.force,2)} \xB1 ${Ts(t.halfwidth,2)}`].forEach(r=>n.insertCell().append(String(r).replace("-","\u2212"))),n}))}function S1(i,e){let t=e.at(-1)?.grasp??0;i.dataset.newest!==String(t)&&(i.dataset.newest=t,i.replaceChildren(...e.toReversed().flatMap(n=>{let[s,r]=["tr","tr"].map(l=>document.createElement(l)),o=[n.peak_n,n.grasp_n,n.slip_mm].map(l=>l??"\u2013");[n.grasp,...o].forEach(l=>s.insertCell().append(String(l)));let a=r.insertCell();return a.colSpan=4,a.append(n.text.replace(/^[^:]*: /,"")),[s,r]})))}function M1(i,e){let t=[];for(let s=0;s<e.length;s+=3){let[,r,o]=e[s].match(/^F(\d)-X(\d+)$/),a=i.insertRow();a.insertCell().append(r),a.insertCell().append(o);for(let l=0;l<3;l++)t.push(a.insertCell())}function n(s){s.forEach((r,o)=>{t[o].className!==cd[r]&&(t[o].className=cd[r],t[o].textContent=cd[r])})}return{show:n}}document.getElementById("instobj-live")&&_1().catch(i=>{document.querySelector('[data-name="trouble"]').textContent=`No live view: ${i.message}.`,console.warn(i)});var b1="instobj objects shown",w1={object:ng,layouts:Ym,grasps:$m};async function q0(i,e){try{return w1[i.dataset.kind](i,await Ds(e))}catch(t){return i.hidden=!0,i.parentElement.querySelector(".no-viewer").textContent=`No view in three dimensions: ${t.message}.`,console.warn(t),null}}async function E1(){let i=[...document.querySelectorAll(".viewer[data-scene]")],e=s=>Ja(document.getElementById(s.dataset.scene).textContent),n=(await Promise.all(i.map(s=>q0(s,e(s))))).filter(s=>s?.press);n.length>1&&Km(n),i.forEach(s=>!s.hidden&&(s.dataset.ready="yes")),requestAnimationFrame(()=>requestAnimationFrame(()=>performance.mark(b1)))}async function T1({model:i,el:e}){if(e.innerHTML=i.get("markup"),e.querySelector("#instobj-explore"))return e.classList.add("explore-widget"),Pf(e,i);let t=i.get("scene"),n=new Uint8Array(t.buffer,t.byteOffset,t.byteLength),s=await q0(e.querySelector(".viewer"),n);s&&(s.host.dataset.ready="yes")}document.querySelector(".viewer[data-scene]")&&requestAnimationFrame(()=>setTimeout(E1));return h_(A1);})();
