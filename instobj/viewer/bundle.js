// made from 92c760ce68f07df06f04f53f2cff303a7c3a34480dadf382090f990b5afe0919
var instobjViewer=(()=>{var Vh=Object.defineProperty;var Y0=Object.getOwnPropertyDescriptor;var $0=Object.getOwnPropertyNames;var Z0=Object.prototype.hasOwnProperty;var J0=(n,e)=>{for(var t in e)Vh(n,t,{get:e[t],enumerable:!0})},K0=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of $0(e))!Z0.call(n,s)&&s!==t&&Vh(n,s,{get:()=>e[s],enumerable:!(i=Y0(e,s))||i.enumerable});return n};var j0=n=>K0(Vh({},"__esModule",{value:!0}),n);var c1={};J0(c1,{render:()=>l1});var Q0={i1:Int8Array,u1:Uint8Array,i2:Int16Array,u2:Uint16Array,u4:Uint32Array,f4:Float32Array};function Wa(n){return Uint8Array.from(atob(n.trim()),e=>e.charCodeAt(0))}async function tr(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("gzip")),t=await new Response(e).arrayBuffer(),i=new DataView(t).getUint32(0,!0),s=JSON.parse(new TextDecoder().decode(new Uint8Array(t,4,i))),r={};for(let[o,a]of Object.entries(s.arrays)){let l=a.shape.reduce((f,h)=>f*h,1),c=new Q0[a.kind](t,4+i+a.at,l),u={i1:127,i2:32767}[a.kind];r[o]={data:c,shape:a.shape,step:a.step,none:a.gaps?u:null}}return{content:s,arrays:r}}function Kn(n){return Float32Array.from(n.data,e=>e===n.none?NaN:e*n.step)}function fn(n,e,t){let i=[];for(let s=e*t;s<(e+1)*t;s++)i.push(n.data[s]*n.step);return i}var Gs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Hs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},jd=0,yu=1,Qd=2;var ga=1,ep=2,lo=3,Ws=0,Un=1,gi=2,lr=0,co=1,vu=2,Su=3,Mu=4,tp=5;var cr=100,np=101,ip=102,sp=103,rp=104,op=200,ap=201,lp=202,cp=203,bu=204,wu=205,hp=206,up=207,fp=208,dp=209,pp=210,mp=211,gp=212,_p=213,xp=214,Sl=0,Ml=1,bl=2,Jr=3,wl=4,El=5,Tl=6,Al=7,Ql=0,yp=1,vp=2,Ji=0,Eu=1,Tu=2,Au=3,Cu=4,Ru=5,Pu=6,Iu=7;var Lu=300,hr=301,ho=302,ec=303,tc=304,Cl=1e3,Xi=1001,Rl=1002,Rn=1003,Sp=1004;var _a=1005;var Dn=1006,nc=1007;var _s=1008;var jn=1009,Du=1010,Nu=1011,uo=1012,ic=1013,Ci=1014,Ri=1015,Pi=1016,sc=1017,rc=1018,ur=1020,Uu=35902,Fu=35899,Ou=1021,Bu=1022,Ii=1023,us=1026,xs=1027,zu=1028,oc=1029,Xs=1030,ac=1031;var lc=1033,xa=33776,ya=33777,va=33778,Sa=33779,cc=35840,hc=35841,uc=35842,fc=35843,dc=36196,pc=37492,mc=37496,gc=37488,_c=37489,Ma=37490,xc=37491,yc=37808,vc=37809,Sc=37810,Mc=37811,bc=37812,wc=37813,Ec=37814,Tc=37815,Ac=37816,Cc=37817,Rc=37818,Pc=37819,Ic=37820,Lc=37821,Dc=36492,Nc=36494,Uc=36495,Fc=36283,Oc=36284,ba=36285,Bc=36286;var Xo=2300,Pl=2301,yl=2302,uu=2303,fu=2400,du=2401,pu=2402;var Mp=3200;var zc=0,bp=1,ys="",kn="srgb",qo="srgb-linear",Yo="linear",Ct="srgb";var vl=7680;var wp=519,Ep=512,Tp=513,Ap=514,ku=515,Cp=516,Rp=517,Vu=518,Gu=519,Hu=35044;var Wu="300 es",pi=2e3,Kr=2001;function e_(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function t_(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function $o(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Pp(){let n=$o("canvas");return n.style.display="block",n}var yd={},jr=null;function Zo(...n){let e="THREE."+n.shift();jr?jr("log",e,...n):console.log(e,...n)}function Ip(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Je(...n){n=Ip(n);let e="THREE."+n.shift();if(jr)jr("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Qe(...n){n=Ip(n);let e="THREE."+n.shift();if(jr)jr("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Ho(...n){let e=n.join(" ");e in yd||(yd[e]=!0,Je(...n))}function Lp(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var Dp={[Sl]:Sl,[bl]:Tl,[wl]:wl,[Jr]:El,[Ml]:Ml,[Tl]:bl,[Al]:Al,[El]:Jr},Ti=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],vd=1234567,$r=Math.PI/180,Qr=180/Math.PI;function qs(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]).toLowerCase()}function dt(n,e,t){return Math.max(e,Math.min(t,n))}function Xu(n,e){return(n%e+e)%e}function n_(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function i_(n,e,t){return n!==e?(t-n)/(e-n):0}function Wo(n,e,t){return(1-t)*n+t*e}function s_(n,e,t,i){return Wo(n,e,1-Math.exp(-t*i))}function r_(n,e=1){return e-Math.abs(Xu(n,e*2)-e)}function o_(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function a_(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function l_(n,e){return n+Math.floor(Math.random()*(e-n+1))}function c_(n,e){return n+Math.random()*(e-n)}function h_(n){return n*(.5-Math.random())}function u_(n){n!==void 0&&(vd=n);let e=vd+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function f_(n){return n*$r}function d_(n){return n*Qr}function p_(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function m_(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function qu(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function g_(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),f=r((e-i)/2),h=o((e-i)/2),p=r((i-e)/2),m=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*m,l*p,a*c);break;case"YXY":n.set(l*p,a*u,l*m,a*c);break;case"ZYZ":n.set(l*m,l*p,a*u,a*c);break;default:Je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function kc(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Yu(n,e){if(e.constructor===Float32Array)return n;let t=kc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function $u(n,e){if(e.constructor===Float32Array)return n;let t=kc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Zu={DEG2RAD:$r,RAD2DEG:Qr,generateUUID:qs,clamp:dt,euclideanModulo:Xu,mapLinear:n_,inverseLerp:i_,lerp:Wo,damp:s_,pingpong:r_,smoothstep:o_,smootherstep:a_,randInt:l_,randFloat:c_,randFloatSpread:h_,seededRandom:u_,degToRad:f_,radToDeg:d_,isPowerOfTwo:p_,ceilPowerOfTwo:m_,floorPowerOfTwo:qu,setQuaternionFromProperEuler:g_,normalize:$u,denormalize:Yu},Ye=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=dt(this.x,e.x,t.x),this.y=dt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=dt(this.x,e,t),this.y=dt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(dt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(dt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},an=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],p=r[o+1],m=r[o+2],_=r[o+3];if(f!==_||l!==h||c!==p||u!==m){let g=l*h+c*p+u*m+f*_;g<0&&(h=-h,p=-p,m=-m,_=-_,g=-g);let d=1-a;if(g<.9995){let y=Math.acos(g),P=Math.sin(y);d=Math.sin(d*y)/P,a=Math.sin(a*y)/P,l=l*d+h*a,c=c*d+p*a,u=u*d+m*a,f=f*d+_*a}else{l=l*d+h*a,c=c*d+p*a,u=u*d+m*a,f=f*d+_*a;let y=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=y,c*=y,u*=y,f*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],p=r[o+2],m=r[o+3];return e[t]=a*m+u*f+l*p-c*h,e[t+1]=l*m+u*h+c*f-a*p,e[t+2]=c*m+u*p+a*h-l*f,e[t+3]=u*m-a*f-l*h-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),p=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*p*m,this._y=c*p*f-h*u*m,this._z=c*u*m+h*p*f,this._w=c*u*f-h*p*m;break;case"YXZ":this._x=h*u*f+c*p*m,this._y=c*p*f-h*u*m,this._z=c*u*m-h*p*f,this._w=c*u*f+h*p*m;break;case"ZXY":this._x=h*u*f-c*p*m,this._y=c*p*f+h*u*m,this._z=c*u*m+h*p*f,this._w=c*u*f-h*p*m;break;case"ZYX":this._x=h*u*f-c*p*m,this._y=c*p*f+h*u*m,this._z=c*u*m-h*p*f,this._w=c*u*f+h*p*m;break;case"YZX":this._x=h*u*f+c*p*m,this._y=c*p*f+h*u*m,this._z=c*u*m-h*p*f,this._w=c*u*f-h*p*m;break;case"XZY":this._x=h*u*f-c*p*m,this._y=c*p*f-h*u*m,this._z=c*u*m+h*p*f,this._w=c*u*f+h*p*m;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let p=.5/Math.sqrt(h+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>f){let p=2*Math.sqrt(1+i-a-f);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>f){let p=2*Math.sqrt(1+a-i-f);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+f-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(dt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Sd.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Sd.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=dt(this.x,e.x,t.x),this.y=dt(this.y,e.y,t.y),this.z=dt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=dt(this.x,e,t),this.y=dt(this.y,e,t),this.z=dt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(dt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Gh.copy(this).projectOnVector(e),this.sub(Gh)}reflect(e){return this.sub(Gh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(dt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Gh=new G,Sd=new an,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],p=i[5],m=i[8],_=s[0],g=s[3],d=s[6],y=s[1],P=s[4],S=s[7],E=s[2],b=s[5],x=s[8];return r[0]=o*_+a*y+l*E,r[3]=o*g+a*P+l*b,r[6]=o*d+a*S+l*x,r[1]=c*_+u*y+f*E,r[4]=c*g+u*P+f*b,r[7]=c*d+u*S+f*x,r[2]=h*_+p*y+m*E,r[5]=h*g+p*P+m*b,r[8]=h*d+p*S+m*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,p=c*r-o*l,m=t*f+i*h+s*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return e[0]=f*_,e[1]=(s*c-u*i)*_,e[2]=(a*i-s*o)*_,e[3]=h*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=p*_,e[7]=(i*l-c*t)*_,e[8]=(o*t-i*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ho("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Hh.makeScale(e,t)),this}rotate(e){return Ho("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Hh.makeRotation(-e)),this}translate(e,t){return Ho("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Hh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Hh=new it,Md=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),bd=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function __(){let n={enabled:!0,workingColorSpace:qo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=hs(s.r),s.g=hs(s.g),s.b=hs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=Zr(s.r),s.g=Zr(s.g),s.b=Zr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?Yo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[qo]:{primaries:e,whitePoint:i,transfer:Yo,toXYZ:Md,fromXYZ:bd,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:kn},outputColorSpaceConfig:{drawingBufferColorSpace:kn}},[kn]:{primaries:e,whitePoint:i,transfer:Ct,toXYZ:Md,fromXYZ:bd,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:kn}}}),n}var _t=__();function hs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Zr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ir,Il=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Ir===void 0&&(Ir=$o("canvas")),Ir.width=e.width,Ir.height=e.height;let s=Ir.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Ir}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=$o("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=hs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(hs(t[i]/255)*255):t[i]=hs(t[i]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},x_=0,eo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:x_++}),this.uuid=qs(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Wh(s[o].image)):r.push(Wh(s[o]))}else r=Wh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Wh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Il.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var y_=0,Xh=new G,Zn=class n extends Ti{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Xi,s=Xi,r=Dn,o=_s,a=Ii,l=jn,c=n.DEFAULT_ANISOTROPY,u=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:y_++}),this.uuid=qs(),this.name="",this.source=new eo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ye(0,0),this.repeat=new Ye(1,1),this.center=new Ye(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Xh).x}get height(){return this.source.getSize(Xh).y}get depth(){return this.source.getSize(Xh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Lu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Cl:e.x=e.x-Math.floor(e.x);break;case Xi:e.x=e.x<0?0:1;break;case Rl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Cl:e.y=e.y-Math.floor(e.y);break;case Xi:e.y=e.y<0?0:1;break;case Rl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Zn.DEFAULT_IMAGE=null;Zn.DEFAULT_MAPPING=Lu;Zn.DEFAULT_ANISOTROPY=1;var $t=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],p=l[5],m=l[9],_=l[2],g=l[6],d=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-_)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+_)<.1&&Math.abs(m+g)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let P=(c+1)/2,S=(p+1)/2,E=(d+1)/2,b=(u+h)/4,x=(f+_)/4,M=(m+g)/4;return P>S&&P>E?P<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(P),s=b/i,r=x/i):S>E?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=b/s,r=M/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=x/r,s=M/r),this.set(i,s,r,t),this}let y=Math.sqrt((g-m)*(g-m)+(f-_)*(f-_)+(h-u)*(h-u));return Math.abs(y)<.001&&(y=1),this.x=(g-m)/y,this.y=(f-_)/y,this.z=(h-u)/y,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=dt(this.x,e.x,t.x),this.y=dt(this.y,e.y,t.y),this.z=dt(this.z,e.z,t.z),this.w=dt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=dt(this.x,e,t),this.y=dt(this.y,e,t),this.z=dt(this.z,e,t),this.w=dt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(dt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ll=class extends Ti{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Dn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new $t(0,0,e,t),this.scissorTest=!1,this.viewport=new $t(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Zn({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Dn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new eo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},oi=class extends Ll{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Jo=class extends Zn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=Xi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Dl=class extends Zn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Rn,this.minFilter=Rn,this.wrapR=Xi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var wt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,p,m,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,p,m,_,g)}set(e,t,i,s,r,o,a,l,c,u,f,h,p,m,_,g){let d=this.elements;return d[0]=e,d[4]=t,d[8]=i,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=f,d[14]=h,d[3]=p,d[7]=m,d[11]=_,d[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Lr.setFromMatrixColumn(e,0).length(),r=1/Lr.setFromMatrixColumn(e,1).length(),o=1/Lr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,p=o*f,m=a*u,_=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=p+m*c,t[5]=h-_*c,t[9]=-a*l,t[2]=_-h*c,t[6]=m+p*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,p=l*f,m=c*u,_=c*f;t[0]=h+_*a,t[4]=m*a-p,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=p*a-m,t[6]=_+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,p=l*f,m=c*u,_=c*f;t[0]=h-_*a,t[4]=-o*f,t[8]=m+p*a,t[1]=p+m*a,t[5]=o*u,t[9]=_-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,p=o*f,m=a*u,_=a*f;t[0]=l*u,t[4]=m*c-p,t[8]=h*c+_,t[1]=l*f,t[5]=_*c+h,t[9]=p*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,p=o*c,m=a*l,_=a*c;t[0]=l*u,t[4]=_-h*f,t[8]=m*f+p,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*f+m,t[10]=h-_*f}else if(e.order==="XZY"){let h=o*l,p=o*c,m=a*l,_=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+_,t[5]=o*u,t[9]=p*f-m,t[2]=m*f-p,t[6]=a*u,t[10]=_*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(v_,e,S_)}lookAt(e,t,i){let s=this.elements;return si.subVectors(e,t),si.lengthSq()===0&&(si.z=1),si.normalize(),Is.crossVectors(i,si),Is.lengthSq()===0&&(Math.abs(i.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Is.crossVectors(i,si)),Is.normalize(),Xa.crossVectors(si,Is),s[0]=Is.x,s[4]=Xa.x,s[8]=si.x,s[1]=Is.y,s[5]=Xa.y,s[9]=si.y,s[2]=Is.z,s[6]=Xa.z,s[10]=si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],p=i[13],m=i[2],_=i[6],g=i[10],d=i[14],y=i[3],P=i[7],S=i[11],E=i[15],b=s[0],x=s[4],M=s[8],N=s[12],A=s[1],C=s[5],D=s[9],F=s[13],I=s[2],z=s[6],X=s[10],B=s[14],he=s[3],Y=s[7],ee=s[11],re=s[15];return r[0]=o*b+a*A+l*I+c*he,r[4]=o*x+a*C+l*z+c*Y,r[8]=o*M+a*D+l*X+c*ee,r[12]=o*N+a*F+l*B+c*re,r[1]=u*b+f*A+h*I+p*he,r[5]=u*x+f*C+h*z+p*Y,r[9]=u*M+f*D+h*X+p*ee,r[13]=u*N+f*F+h*B+p*re,r[2]=m*b+_*A+g*I+d*he,r[6]=m*x+_*C+g*z+d*Y,r[10]=m*M+_*D+g*X+d*ee,r[14]=m*N+_*F+g*B+d*re,r[3]=y*b+P*A+S*I+E*he,r[7]=y*x+P*C+S*z+E*Y,r[11]=y*M+P*D+S*X+E*ee,r[15]=y*N+P*F+S*B+E*re,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],p=e[14],m=e[3],_=e[7],g=e[11],d=e[15],y=l*p-c*h,P=a*p-c*f,S=a*h-l*f,E=o*p-c*u,b=o*h-l*u,x=o*f-a*u;return t*(_*y-g*P+d*S)-i*(m*y-g*E+d*b)+s*(m*P-_*E+d*x)-r*(m*S-_*b+g*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],p=e[11],m=e[12],_=e[13],g=e[14],d=e[15],y=t*a-i*o,P=t*l-s*o,S=t*c-r*o,E=i*l-s*a,b=i*c-r*a,x=s*c-r*l,M=u*_-f*m,N=u*g-h*m,A=u*d-p*m,C=f*g-h*_,D=f*d-p*_,F=h*d-p*g,I=y*F-P*D+S*C+E*A-b*N+x*M;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/I;return e[0]=(a*F-l*D+c*C)*z,e[1]=(s*D-i*F-r*C)*z,e[2]=(_*x-g*b+d*E)*z,e[3]=(h*b-f*x-p*E)*z,e[4]=(l*A-o*F-c*N)*z,e[5]=(t*F-s*A+r*N)*z,e[6]=(g*S-m*x-d*P)*z,e[7]=(u*x-h*S+p*P)*z,e[8]=(o*D-a*A+c*M)*z,e[9]=(i*A-t*D-r*M)*z,e[10]=(m*b-_*S+d*y)*z,e[11]=(f*S-u*b-p*y)*z,e[12]=(a*N-o*C-l*M)*z,e[13]=(t*C-i*N+s*M)*z,e[14]=(_*P-m*E-g*y)*z,e[15]=(u*E-f*P+h*y)*z,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,p=r*u,m=r*f,_=o*u,g=o*f,d=a*f,y=l*c,P=l*u,S=l*f,E=i.x,b=i.y,x=i.z;return s[0]=(1-(_+d))*E,s[1]=(p+S)*E,s[2]=(m-P)*E,s[3]=0,s[4]=(p-S)*b,s[5]=(1-(h+d))*b,s[6]=(g+y)*b,s[7]=0,s[8]=(m+P)*x,s[9]=(g-y)*x,s[10]=(1-(h+_))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Lr.set(s[0],s[1],s[2]).length(),a=Lr.set(s[4],s[5],s[6]).length(),l=Lr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),bi.copy(this);let c=1/o,u=1/a,f=1/l;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=u,bi.elements[5]*=u,bi.elements[6]*=u,bi.elements[8]*=f,bi.elements[9]*=f,bi.elements[10]*=f,t.setFromRotationMatrix(bi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=pi,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),p=(i+s)/(i-s),m,_;if(l)m=r/(o-r),_=o*r/(o-r);else if(a===pi)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Kr)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=pi,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),p=-(i+s)/(i-s),m,_;if(l)m=1/(o-r),_=o/(o-r);else if(a===pi)m=-2/(o-r),_=-(o+r)/(o-r);else if(a===Kr)m=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Lr=new G,bi=new wt,v_=new G(0,0,0),S_=new G(1,1,1),Is=new G,Xa=new G,si=new G,wd=new wt,Ed=new an,fs=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(dt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-dt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(dt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-dt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(dt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-dt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return wd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(wd,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Ed.setFromEuler(this),this.setFromQuaternion(Ed,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};fs.DEFAULT_ORDER="XYZ";var to=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},M_=0,Td=new G,Dr=new an,rs=new wt,qa=new G,Uo=new G,b_=new G,w_=new an,Ad=new G(1,0,0),Cd=new G(0,1,0),Rd=new G(0,0,1),Pd={type:"added"},E_={type:"removed"},Nr={type:"childadded",child:null},qh={type:"childremoved",child:null},Nn=class n extends Ti{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:M_++}),this.uuid=qs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new G,t=new fs,i=new an,s=new G(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new wt},normalMatrix:{value:new it}}),this.matrix=new wt,this.matrixWorld=new wt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new to,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Dr.setFromAxisAngle(e,t),this.quaternion.multiply(Dr),this}rotateOnWorldAxis(e,t){return Dr.setFromAxisAngle(e,t),this.quaternion.premultiply(Dr),this}rotateX(e){return this.rotateOnAxis(Ad,e)}rotateY(e){return this.rotateOnAxis(Cd,e)}rotateZ(e){return this.rotateOnAxis(Rd,e)}translateOnAxis(e,t){return Td.copy(e).applyQuaternion(this.quaternion),this.position.add(Td.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Ad,e)}translateY(e){return this.translateOnAxis(Cd,e)}translateZ(e){return this.translateOnAxis(Rd,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(rs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?qa.copy(e):qa.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Uo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?rs.lookAt(Uo,qa,this.up):rs.lookAt(qa,Uo,this.up),this.quaternion.setFromRotationMatrix(rs),s&&(rs.extractRotation(s.matrixWorld),Dr.setFromRotationMatrix(rs),this.quaternion.premultiply(Dr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Pd),Nr.child=e,this.dispatchEvent(Nr),Nr.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(E_),qh.child=e,this.dispatchEvent(qh),qh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),rs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),rs.multiply(e.parent.matrixWorld)),e.applyMatrix4(rs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Pd),Nr.child=e,this.dispatchEvent(Nr),Nr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Uo,e,b_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Uo,w_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),p=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),p.length>0&&(i.animations=p),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new G(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Xt=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},T_={type:"move"},no=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Xt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Xt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Xt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let g=t.getJointPose(_,i),d=this._getHandJoint(c,_);g!==null&&(d.matrix.fromArray(g.transform.matrix),d.matrix.decompose(d.position,d.quaternion,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=g.radius),d.visible=g!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),p=.02,m=.005;c.inputState.pinching&&h>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(T_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Xt;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Np={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ls={h:0,s:0,l:0},Ya={h:0,s:0,l:0};function Yh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var rt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=kn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,_t.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=_t.workingColorSpace){return this.r=e,this.g=t,this.b=i,_t.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=_t.workingColorSpace){if(e=Xu(e,1),t=dt(t,0,1),i=dt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Yh(o,r,e+1/3),this.g=Yh(o,r,e),this.b=Yh(o,r,e-1/3)}return _t.colorSpaceToWorking(this,s),this}setStyle(e,t=kn){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=kn){let i=Np[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=hs(e.r),this.g=hs(e.g),this.b=hs(e.b),this}copyLinearToSRGB(e){return this.r=Zr(e.r),this.g=Zr(e.g),this.b=Zr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=kn){return _t.workingToColorSpace(zn.copy(this),e),Math.round(dt(zn.r*255,0,255))*65536+Math.round(dt(zn.g*255,0,255))*256+Math.round(dt(zn.b*255,0,255))}getHexString(e=kn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.workingToColorSpace(zn.copy(this),t);let i=zn.r,s=zn.g,r=zn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=_t.workingColorSpace){return _t.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=kn){_t.workingToColorSpace(zn.copy(this),e);let t=zn.r,i=zn.g,s=zn.b;return e!==kn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ls),this.setHSL(Ls.h+e,Ls.s+t,Ls.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ls),e.getHSL(Ya);let i=Wo(Ls.h,Ya.h,t),s=Wo(Ls.s,Ya.s,t),r=Wo(Ls.l,Ya.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new rt;rt.NAMES=Np;var Ko=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new fs,this.environmentIntensity=1,this.environmentRotation=new fs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},wi=new G,os=new G,$h=new G,as=new G,Ur=new G,Fr=new G,Id=new G,Zh=new G,Jh=new G,Kh=new G,jh=new $t,Qh=new $t,eu=new $t,Wi=class n{constructor(e=new G,t=new G,i=new G){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),wi.subVectors(e,t),s.cross(wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){wi.subVectors(s,t),os.subVectors(i,t),$h.subVectors(e,t);let o=wi.dot(wi),a=wi.dot(os),l=wi.dot($h),c=os.dot(os),u=os.dot($h),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,p=(c*l-a*u)*h,m=(o*u-a*l)*h;return r.set(1-p-m,m,p)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,as)===null?!1:as.x>=0&&as.y>=0&&as.x+as.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,as)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,as.x),l.addScaledVector(o,as.y),l.addScaledVector(a,as.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return jh.setScalar(0),Qh.setScalar(0),eu.setScalar(0),jh.fromBufferAttribute(e,t),Qh.fromBufferAttribute(e,i),eu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(jh,r.x),o.addScaledVector(Qh,r.y),o.addScaledVector(eu,r.z),o}static isFrontFacing(e,t,i,s){return wi.subVectors(i,t),os.subVectors(e,t),wi.cross(os).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return wi.subVectors(this.c,this.b),os.subVectors(this.a,this.b),wi.cross(os).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Ur.subVectors(s,i),Fr.subVectors(r,i),Zh.subVectors(e,i);let l=Ur.dot(Zh),c=Fr.dot(Zh);if(l<=0&&c<=0)return t.copy(i);Jh.subVectors(e,s);let u=Ur.dot(Jh),f=Fr.dot(Jh);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Ur,o);Kh.subVectors(e,r);let p=Ur.dot(Kh),m=Fr.dot(Kh);if(m>=0&&p<=m)return t.copy(r);let _=p*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(Fr,a);let g=u*m-p*f;if(g<=0&&f-u>=0&&p-m>=0)return Id.subVectors(r,s),a=(f-u)/(f-u+(p-m)),t.copy(s).addScaledVector(Id,a);let d=1/(g+_+h);return o=_*d,a=h*d,t.copy(i).addScaledVector(Ur,o).addScaledVector(Fr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},qi=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ei.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ei.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ei.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ei):Ei.fromBufferAttribute(r,o),Ei.applyMatrix4(e.matrixWorld),this.expandByPoint(Ei);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),$a.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),$a.copy(i.boundingBox)),$a.applyMatrix4(e.matrixWorld),this.union($a)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ei),Ei.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Fo),Za.subVectors(this.max,Fo),Or.subVectors(e.a,Fo),Br.subVectors(e.b,Fo),zr.subVectors(e.c,Fo),Ds.subVectors(Br,Or),Ns.subVectors(zr,Br),nr.subVectors(Or,zr);let t=[0,-Ds.z,Ds.y,0,-Ns.z,Ns.y,0,-nr.z,nr.y,Ds.z,0,-Ds.x,Ns.z,0,-Ns.x,nr.z,0,-nr.x,-Ds.y,Ds.x,0,-Ns.y,Ns.x,0,-nr.y,nr.x,0];return!tu(t,Or,Br,zr,Za)||(t=[1,0,0,0,1,0,0,0,1],!tu(t,Or,Br,zr,Za))?!1:(Ja.crossVectors(Ds,Ns),t=[Ja.x,Ja.y,Ja.z],tu(t,Or,Br,zr,Za))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ei).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ei).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ls),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ls=[new G,new G,new G,new G,new G,new G,new G,new G],Ei=new G,$a=new qi,Or=new G,Br=new G,zr=new G,Ds=new G,Ns=new G,nr=new G,Fo=new G,Za=new G,Ja=new G,ir=new G;function tu(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){ir.fromArray(n,r);let a=s.x*Math.abs(ir.x)+s.y*Math.abs(ir.y)+s.z*Math.abs(ir.z),l=e.dot(ir),c=t.dot(ir),u=i.dot(ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var dn=new G,Ka=new Ye,A_=0,Ln=class extends Ti{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:A_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Hu,this.updateRanges=[],this.gpuType=Ri,this.version=0,this._normalizationScale=e!==void 0?kc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Ka.fromBufferAttribute(this,t),Ka.applyMatrix3(e),this.setXY(t,Ka.x,Ka.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)dn.fromBufferAttribute(this,t),dn.applyMatrix3(e),this.setXYZ(t,dn.x,dn.y,dn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)dn.fromBufferAttribute(this,t),dn.applyMatrix4(e),this.setXYZ(t,dn.x,dn.y,dn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)dn.fromBufferAttribute(this,t),dn.applyNormalMatrix(e),this.setXYZ(t,dn.x,dn.y,dn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)dn.fromBufferAttribute(this,t),dn.transformDirection(e),this.setXYZ(t,dn.x,dn.y,dn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Yu(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):$u(e,this.array)}};var jo=class extends Ln{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Qo=class extends Ln{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ft=class extends Ln{constructor(e,t,i){super(new Float32Array(e),t,i)}},C_=new qi,Oo=new G,nu=new G,ds=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):C_.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Oo.subVectors(e,this.center);let t=Oo.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Oo,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(nu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Oo.copy(e.center).add(nu)),this.expandByPoint(Oo.copy(e.center).sub(nu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},R_=0,di=new wt,iu=new Nn,kr=new G,ri=new qi,Bo=new qi,Cn=new G,pn=class n extends Ti{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:R_++}),this.uuid=qs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(e_(e)?Qo:jo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new it().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return di.makeRotationFromQuaternion(e),this.applyMatrix4(di),this}rotateX(e){return di.makeRotationX(e),this.applyMatrix4(di),this}rotateY(e){return di.makeRotationY(e),this.applyMatrix4(di),this}rotateZ(e){return di.makeRotationZ(e),this.applyMatrix4(di),this}translate(e,t,i){return di.makeTranslation(e,t,i),this.applyMatrix4(di),this}scale(e,t,i){return di.makeScale(e,t,i),this.applyMatrix4(di),this}lookAt(e){return iu.lookAt(e),iu.updateMatrix(),this.applyMatrix4(iu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(kr).negate(),this.translate(kr.x,kr.y,kr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ft(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ds);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let i=this.boundingSphere.center;if(ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Bo.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(ri.min,Bo.min),ri.expandByPoint(Cn),Cn.addVectors(ri.max,Bo.max),ri.expandByPoint(Cn)):(ri.expandByPoint(Bo.min),ri.expandByPoint(Bo.max))}ri.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Cn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Cn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Cn.fromBufferAttribute(a,c),l&&(kr.fromBufferAttribute(e,c),Cn.add(kr)),s=Math.max(s,i.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ln(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let N=0;N<i.count;N++)a[N]=new G,l[N]=new G;let u=new G,f=new G,h=new G,p=new Ye,m=new Ye,_=new Ye,g=new G,d=new G;function y(N,A,C){c[N]=c[A]=c[C]=1,u.fromBufferAttribute(i,N),f.fromBufferAttribute(i,A),h.fromBufferAttribute(i,C),p.fromBufferAttribute(r,N),m.fromBufferAttribute(r,A),_.fromBufferAttribute(r,C),f.sub(u),h.sub(u),m.sub(p),_.sub(p);let D=1/(m.x*_.y-_.x*m.y);isFinite(D)&&(g.copy(f).multiplyScalar(_.y).addScaledVector(h,-m.y).multiplyScalar(D),d.copy(h).multiplyScalar(m.x).addScaledVector(f,-_.x).multiplyScalar(D),a[N].add(g),a[A].add(g),a[C].add(g),l[N].add(d),l[A].add(d),l[C].add(d))}let P=this.groups;P.length===0&&(P=[{start:0,count:e.count}]);for(let N=0,A=P.length;N<A;++N){let C=P[N],D=C.start,F=C.count;for(let I=D,z=D+F;I<z;I+=3)y(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let S=new G,E=new G,b=new G,x=new G;function M(N){b.fromBufferAttribute(s,N),x.copy(b);let A=a[N];S.copy(A),S.sub(b.multiplyScalar(b.dot(A))).normalize(),E.crossVectors(x,A);let D=E.dot(l[N])<0?-1:1;o.setXYZW(N,S.x,S.y,S.z,D)}for(let N=0,A=i.count;N<A;++N)c[N]&&M(N);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Ln(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,p=i.count;h<p;h++)i.setXYZ(h,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,f=new G;if(e)for(let h=0,p=e.count;h<p;h+=3){let m=e.getX(h+0),_=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,g),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,p=t.count;h<p;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Cn.fromBufferAttribute(e,t),Cn.normalize(),e.setXYZ(t,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),p=0,m=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?p=l[_]*a.data.stride+a.offset:p=l[_]*u;for(let d=0;d<u;d++)h[m++]=c[p++]}return new Ln(h,u,f)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],p=e(h,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let p=c[f];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,p=f.length;h<p;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Nl=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Hu,this.updateRanges=[],this.version=0,this.uuid=qs()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Ld(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Ld(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Ld(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=qs()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Yn=new G,ea=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?kc(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)Yn.fromBufferAttribute(this,t),Yn.applyMatrix4(e),this.setXYZ(t,Yn.x,Yn.y,Yn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Yn.fromBufferAttribute(this,t),Yn.applyNormalMatrix(e),this.setXYZ(t,Yn.x,Yn.y,Yn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Yn.fromBufferAttribute(this,t),Yn.transformDirection(e),this.setXYZ(t,Yn.x,Yn.y,Yn.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Zo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Ln(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Zo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Yu(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):$u(e,this.data.array)}},su=new G,P_=new G,I_=new it,In=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=su.subVectors(i,t).cross(P_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(su),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||I_.getNormalMatrix(e),s=this.coplanarPoint(su).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},L_=0,Yi=class extends Ti{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:L_++}),this.uuid=qs(),this.name="",this.type="Material",this.blending=co,this.side=Ws,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=bu,this.blendDst=wu,this.blendEquation=cr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new rt(0,0,0),this.blendAlpha=0,this.depthFunc=Jr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=wp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=vl,this.stencilZFail=vl,this.stencilZPass=vl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new rt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new In().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ye().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ye().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},io=class extends Yi{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new rt(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Vr,zo=new G,Gr=new G,Hr=new G,Wr=new Ye,ko=new Ye,Up=new wt,ja=new G,Vo=new G,Qa=new G,Dd=new Ye,ru=new Ye,Nd=new Ye,ta=class extends Nn{constructor(e=new io){if(super(),this.isSprite=!0,this.type="Sprite",Vr===void 0){Vr=new pn;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Nl(t,5);Vr.setIndex([0,1,2,0,2,3]),Vr.setAttribute("position",new ea(i,3,0,!1)),Vr.setAttribute("uv",new ea(i,2,3,!1))}this.geometry=Vr,this.material=e,this.center=new Ye(.5,.5),this.count=1}intersectsFrustum(e){return e.intersectsSprite(this)}raycast(e,t){e.camera===null&&Qe('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Gr.setFromMatrixScale(this.matrixWorld),Up.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),Hr.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Gr.multiplyScalar(-Hr.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;el(ja.set(-.5,-.5,0),Hr,o,Gr,s,r),el(Vo.set(.5,-.5,0),Hr,o,Gr,s,r),el(Qa.set(.5,.5,0),Hr,o,Gr,s,r),Dd.set(0,0),ru.set(1,0),Nd.set(1,1);let a=e.ray.intersectTriangle(ja,Vo,Qa,!1,zo);if(a===null&&(el(Vo.set(-.5,.5,0),Hr,o,Gr,s,r),ru.set(0,1),a=e.ray.intersectTriangle(ja,Qa,Vo,!1,zo),a===null))return;let l=e.ray.origin.distanceTo(zo);l<e.near||l>e.far||t.push({distance:l,point:zo.clone(),uv:Wi.getInterpolation(zo,ja,Vo,Qa,Dd,ru,Nd,new Ye),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}toJSON(e){let t=super.toJSON(e);return t.object.center=this.center.toArray(),t}};function el(n,e,t,i,s,r){Wr.subVectors(n,t).addScalar(.5).multiply(i),s!==void 0?(ko.x=r*Wr.x-s*Wr.y,ko.y=s*Wr.x+r*Wr.y):ko.copy(Wr),n.copy(e),n.x+=ko.x,n.y+=ko.y,n.applyMatrix4(Up)}var cs=new G,ou=new G,tl=new G,nl=new G,Fs=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,cs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=cs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(cs.copy(this.origin).addScaledVector(this.direction,t),cs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){ou.copy(e).add(t).multiplyScalar(.5),tl.copy(t).sub(e).normalize(),nl.copy(this.origin).sub(ou);let r=e.distanceTo(t)*.5,o=-this.direction.dot(tl),a=nl.dot(this.direction),l=-nl.dot(tl),c=nl.lengthSq(),u=Math.abs(1-o*o),f,h,p,m;if(u>0)if(f=o*l-a,h=o*a-l,m=r*u,f>=0)if(h>=-m)if(h<=m){let _=1/u;f*=_,h*=_,p=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;else h<=-m?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),p=-f*f+h*(h+2*l)+c):h<=m?(f=0,h=Math.min(Math.max(-r,-l),r),p=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),p=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(ou).addScaledVector(tl,h),p}intersectSphere(e,t){if(e.radius<0)return null;cs.subVectors(e.center,this.origin);let i=cs.dot(this.direction),s=cs.dot(cs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,cs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,p=e.z-o.z,m=t.x-o.x,_=t.y-o.y,g=t.z-o.z,d=i.x-o.x,y=i.y-o.y,P=i.z-o.z,S=Math.abs(l),E=Math.abs(c),b=Math.abs(u),x,M,N,A,C,D,F,I,z,X,B,he;if(S>=E&&S>=b?(N=l,D=f,z=m,he=d,l>=0?(x=c,M=u,A=h,C=p,F=_,I=g,X=y,B=P):(x=u,M=c,A=p,C=h,F=g,I=_,X=P,B=y)):E>=b?(N=c,D=h,z=_,he=y,c>=0?(x=u,M=l,A=p,C=f,F=g,I=m,X=P,B=d):(x=l,M=u,A=f,C=p,F=m,I=g,X=d,B=P)):(N=u,D=p,z=g,he=P,u>=0?(x=l,M=c,A=f,C=h,F=m,I=_,X=d,B=y):(x=c,M=l,A=h,C=f,F=_,I=m,X=y,B=d)),N===0)return null;let Y=x/N,ee=M/N,re=1/N,Q=A-Y*D,ie=C-ee*D,Z=F-Y*z,de=I-ee*z,se=X-Y*he,ge=B-ee*he,me=se*de-ge*Z,W=Q*ge-ie*se,ne=Z*ie-de*Q;if(s){if(me<0||W<0||ne<0)return null}else if((me<0||W<0||ne<0)&&(me>0||W>0||ne>0))return null;let le=me+W+ne;if(le===0)return null;let De=re*(me*D+W*z+ne*he);return(le>0?De<0:De>0)?null:this.at(De/le,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Os=class extends Yi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new rt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fs,this.combine=Ql,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Ud=new wt,sr=new Fs,il=new ds,Fd=new G,sl=new G,rl=new G,ol=new G,au=new G,al=new G,Od=new G,ll=new G,Et=class extends Nn{constructor(e=new pn,t=new Os){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){al.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(au.fromBufferAttribute(f,e),o?al.addScaledVector(au,u):al.addScaledVector(au.sub(t),u))}t.add(al)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),il.copy(i.boundingSphere),il.applyMatrix4(r),sr.copy(e.ray).recast(e.near),!(il.containsPoint(sr.origin)===!1&&(sr.intersectSphere(il,Fd)===null||sr.origin.distanceToSquared(Fd)>(e.far-e.near)**2))&&(Ud.copy(r).invert(),sr.copy(e.ray).applyMatrix4(Ud),!(i.boundingBox!==null&&sr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,sr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=h.length;m<_;m++){let g=h[m],d=o[g.materialIndex],y=Math.max(g.start,p.start),P=Math.min(a.count,Math.min(g.start+g.count,p.start+p.count));for(let S=y,E=P;S<E;S+=3){let b=a.getX(S),x=a.getX(S+1),M=a.getX(S+2);s=cl(this,d,e,i,c,u,f,b,x,M),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,p.start),_=Math.min(a.count,p.start+p.count);for(let g=m,d=_;g<d;g+=3){let y=a.getX(g),P=a.getX(g+1),S=a.getX(g+2);s=cl(this,o,e,i,c,u,f,y,P,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=h.length;m<_;m++){let g=h[m],d=o[g.materialIndex],y=Math.max(g.start,p.start),P=Math.min(l.count,Math.min(g.start+g.count,p.start+p.count));for(let S=y,E=P;S<E;S+=3){let b=S,x=S+1,M=S+2;s=cl(this,d,e,i,c,u,f,b,x,M),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,p.start),_=Math.min(l.count,p.start+p.count);for(let g=m,d=_;g<d;g+=3){let y=g,P=g+1,S=g+2;s=cl(this,o,e,i,c,u,f,y,P,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function D_(n,e,t,i,s,r,o,a){let l;if(e.side===Un?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Ws,a),l===null)return null;ll.copy(a),ll.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(ll);return c<t.near||c>t.far?null:{distance:c,point:ll.clone(),object:n}}function cl(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,sl),n.getVertexPosition(l,rl),n.getVertexPosition(c,ol);let u=D_(n,e,t,i,sl,rl,ol,Od);if(u){let f=new G;Wi.getBarycoord(Od,sl,rl,ol,f),s&&(u.uv=Wi.getInterpolatedAttribute(s,a,l,c,f,new Ye)),r&&(u.uv1=Wi.getInterpolatedAttribute(r,a,l,c,f,new Ye)),o&&(u.normal=Wi.getInterpolatedAttribute(o,a,l,c,f,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new G,materialIndex:0};Wi.getNormal(sl,rl,ol,h.normal),u.face=h,u.barycoord=f}return u}var so=class extends Zn{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Rn,u=Rn,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var rr=new ds,N_=new Ye(.5,.5),hl=new G,Bs=class{constructor(e=new In,t=new In,i=new In,s=new In,r=new In,o=new In){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=pi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],p=r[7],m=r[8],_=r[9],g=r[10],d=r[11],y=r[12],P=r[13],S=r[14],E=r[15];if(s[0].setComponents(c-o,p-u,d-m,E-y).normalize(),s[1].setComponents(c+o,p+u,d+m,E+y).normalize(),s[2].setComponents(c+a,p+f,d+_,E+P).normalize(),s[3].setComponents(c-a,p-f,d-_,E-P).normalize(),i)s[4].setComponents(l,h,g,S).normalize(),s[5].setComponents(c-l,p-h,d-g,E-S).normalize();else if(s[4].setComponents(c-l,p-h,d-g,E-S).normalize(),t===pi)s[5].setComponents(c+l,p+h,d+g,E+S).normalize();else if(t===Kr)s[5].setComponents(l,h,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(e){rr.center.set(0,0,0);let t=N_.distanceTo(e.center);return rr.radius=.7071067811865476+t,rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(hl.x=s.normal.x>0?e.max.x:e.min.x,hl.y=s.normal.y>0?e.max.y:e.min.y,hl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(hl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Bd=new wt,Ul=class n{constructor(){this.coordinateSystem=pi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Bd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Bs),i[s].setFromProjectionMatrix(Bd,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Bs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var mi=class extends Yi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new rt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Fl=new G,Ol=new G,zd=new wt,Go=new Fs,ul=new ds,lu=new G,kd=new G,ro=class extends Nn{constructor(e=new pn,t=new mi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Fl.fromBufferAttribute(t,s-1),Ol.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Fl.distanceTo(Ol);e.setAttribute("lineDistance",new Ft(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ul.copy(i.boundingSphere),ul.applyMatrix4(s),ul.radius+=r,e.ray.intersectsSphere(ul)===!1)return;zd.copy(s).invert(),Go.copy(e.ray).applyMatrix4(zd);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let _=p,g=m-1;_<g;_+=c){let d=u.getX(_),y=u.getX(_+1),P=fl(this,e,Go,l,d,y,_);P&&t.push(P)}if(this.isLineLoop){let _=u.getX(m-1),g=u.getX(p),d=fl(this,e,Go,l,_,g,m-1);d&&t.push(d)}}else{let p=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let _=p,g=m-1;_<g;_+=c){let d=fl(this,e,Go,l,_,_+1,_);d&&t.push(d)}if(this.isLineLoop){let _=fl(this,e,Go,l,m-1,p,m-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function fl(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Fl.fromBufferAttribute(a,s),Ol.fromBufferAttribute(a,r),t.distanceSqToSegment(Fl,Ol,lu,kd)>i)return;lu.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(lu);if(!(c<e.near||c>e.far))return{distance:c,point:kd.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Vd=new G,Gd=new G,ps=class extends ro{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Vd.fromBufferAttribute(t,s),Gd.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Vd.distanceTo(Gd);e.setAttribute("lineDistance",new Ft(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var na=class extends Zn{constructor(e=[],t=hr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},ia=class extends Zn{constructor(e,t,i,s,r,o,a,l,c){super(e,t,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var ms=class extends Zn{constructor(e,t,i=Ci,s,r,o,a=Rn,l=Rn,c,u=us,f=1){if(u!==us&&u!==xs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new eo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},sa=class extends ms{constructor(e,t=Ci,i=hr,s,r,o=Rn,a=Rn,l,c=us){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ra=class extends Zn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Ai=class n extends pn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,p=0;m("z","y","x",-1,-1,i,t,e,o,r,0),m("z","y","x",1,-1,i,t,-e,o,r,1),m("x","z","y",1,1,e,i,t,s,o,2),m("x","z","y",1,-1,e,i,-t,s,o,3),m("x","y","z",1,-1,e,t,i,s,r,4),m("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ft(c,3)),this.setAttribute("normal",new Ft(u,3)),this.setAttribute("uv",new Ft(f,2));function m(_,g,d,y,P,S,E,b,x,M,N){let A=S/x,C=E/M,D=S/2,F=E/2,I=b/2,z=x+1,X=M+1,B=0,he=0,Y=new G;for(let ee=0;ee<X;ee++){let re=ee*C-F;for(let Q=0;Q<z;Q++){let ie=Q*A-D;Y[_]=ie*y,Y[g]=re*P,Y[d]=I,c.push(Y.x,Y.y,Y.z),Y[_]=0,Y[g]=0,Y[d]=b>0?1:-1,u.push(Y.x,Y.y,Y.z),f.push(Q/x),f.push(1-ee/M),B+=1}}for(let ee=0;ee<M;ee++)for(let re=0;re<x;re++){let Q=h+re+z*ee,ie=h+re+z*(ee+1),Z=h+(re+1)+z*(ee+1),de=h+(re+1)+z*ee;l.push(Q,ie,de),l.push(ie,Z,de),he+=6}a.addGroup(p,he,N),p+=he,h+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var $i=class n extends pn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],f=[],h=[],p=[],m=0,_=[],g=i/2,d=0;y(),o===!1&&(e>0&&P(!0),t>0&&P(!1)),this.setIndex(u),this.setAttribute("position",new Ft(f,3)),this.setAttribute("normal",new Ft(h,3)),this.setAttribute("uv",new Ft(p,2));function y(){let S=new G,E=new G,b=0,x=(t-e)/i;for(let M=0;M<=r;M++){let N=[],A=M/r,C=A*(t-e)+e;for(let D=0;D<=s;D++){let F=D/s,I=F*l+a,z=Math.sin(I),X=Math.cos(I);E.x=C*z,E.y=-A*i+g,E.z=C*X,f.push(E.x,E.y,E.z),S.set(z,x,X).normalize(),h.push(S.x,S.y,S.z),p.push(F,1-A),N.push(m++)}_.push(N)}for(let M=0;M<s;M++)for(let N=0;N<r;N++){let A=_[N][M],C=_[N+1][M],D=_[N+1][M+1],F=_[N][M+1];(e>0||N!==0)&&(u.push(A,C,F),b+=3),(t>0||N!==r-1)&&(u.push(C,D,F),b+=3)}c.addGroup(d,b,0),d+=b}function P(S){let E=m,b=new Ye,x=new G,M=0,N=S===!0?e:t,A=S===!0?1:-1;for(let D=1;D<=s;D++)f.push(0,g*A,0),h.push(0,A,0),p.push(.5,.5),m++;let C=m;for(let D=0;D<=s;D++){let I=D/s*l+a,z=Math.cos(I),X=Math.sin(I);x.x=N*X,x.y=g*A,x.z=N*z,f.push(x.x,x.y,x.z),h.push(0,A,0),b.x=z*.5+.5,b.y=X*.5*A+.5,p.push(b.x,b.y),m++}for(let D=0;D<s;D++){let F=E+D,I=C+D;S===!0?u.push(I,I+1,F):u.push(I+1,I,F),M+=3}c.addGroup(d,M,S===!0?1:2),d+=M}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},oa=class n extends $i{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var dl=new G,pl=new G,cu=new G,ml=new Wi,or=class extends pn{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos($r*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],f=new Array(3),h=new Map,p=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:_,b:g,c:d}=ml;if(_.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),d.fromBufferAttribute(a,c[2]),ml.getNormal(cu),f[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,f[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,f[2]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let y=0;y<3;y++){let P=(y+1)%3,S=f[y],E=f[P],b=ml[u[y]],x=ml[u[P]],M=`${S}_${E}`,N=`${E}_${S}`,A=h.get(N);A?(cu.dot(A.normal)<=r&&(p.push(b.x,b.y,b.z),p.push(x.x,x.y,x.z)),h.set(N,null)):h.has(M)||h.set(M,{index0:c[y],index1:c[P],normal:cu.clone()})}}for(let m of h.values())if(m){let{index0:_,index1:g}=m;dl.fromBufferAttribute(a,_),pl.fromBufferAttribute(a,g),p.push(dl.x,dl.y,dl.z),p.push(pl.x,pl.y,pl.z)}this.setAttribute("position",new Ft(p,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var aa=class n extends pn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,p=[],m=[],_=[],g=[];for(let d=0;d<u;d++){let y=d*h-o;for(let P=0;P<c;P++){let S=P*f-r;m.push(S,-y,0),_.push(0,0,1),g.push(P/a),g.push(1-d/l)}}for(let d=0;d<l;d++)for(let y=0;y<a;y++){let P=y+c*d,S=y+c*(d+1),E=y+1+c*(d+1),b=y+1+c*d;p.push(P,S,b),p.push(S,E,b)}this.setIndex(p),this.setAttribute("position",new Ft(m,3)),this.setAttribute("normal",new Ft(_,3)),this.setAttribute("uv",new Ft(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var ar=class n extends pn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],f=new G,h=new G,p=[],m=[],_=[],g=[];for(let d=0;d<=i;d++){let y=[],P=d/i,S=o+P*a,E=e*Math.cos(S),b=Math.sqrt(e*e-E*E),x=0;d===0&&o===0?x=.5/t:d===i&&l===Math.PI&&(x=-.5/t);for(let M=0;M<=t;M++){let N=M/t,A=s+N*r;f.x=-b*Math.cos(A),f.y=E,f.z=b*Math.sin(A),m.push(f.x,f.y,f.z),h.copy(f).normalize(),_.push(h.x,h.y,h.z),g.push(N+x,1-P),y.push(c++)}u.push(y)}for(let d=0;d<i;d++)for(let y=0;y<t;y++){let P=u[d][y+1],S=u[d][y],E=u[d+1][y],b=u[d+1][y+1];(d!==0||o>0)&&p.push(P,S,b),(d!==i-1||l<Math.PI)&&p.push(S,E,b)}this.setIndex(p),this.setAttribute("position",new Ft(m,3)),this.setAttribute("normal",new Ft(_,3)),this.setAttribute("uv",new Ft(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function fr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Hd(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Hd(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Vn(n){let e={};for(let t=0;t<n.length;t++){let i=fr(n[t]);for(let s in i)e[s]=i[s]}return e}function Hd(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function U_(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Ju(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:_t.workingColorSpace}var Fp={clone:fr,merge:Vn},F_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,O_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Zi=class extends Yi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=F_,this.fragmentShader=O_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=fr(e.uniforms),this.uniformsGroups=U_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new rt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ye().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new $t().fromArray(s.value);break;case"m3":this.uniforms[i].value=new it().fromArray(s.value);break;case"m4":this.uniforms[i].value=new wt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Bl=class extends Zi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var mn=class extends Yi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new rt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new rt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=zc,this.normalScale=new Ye(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fs,this.combine=Ql,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},zl=class extends Yi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Mp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},kl=class extends Yi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Xr(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function gl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var zs=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Vl=class extends zs{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:fu,endingEnd:fu}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case du:r=e,a=2*t-i;break;case pu:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case du:o=e,l=2*i-t;break;case pu:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,p=this._weightNext,m=(i-t)/(s-t),_=m*m,g=_*m,d=-h*g+2*h*_-h*m,y=(1+h)*g+(-1.5-2*h)*_+(-.5+h)*m+1,P=(-1-p)*g+(1.5+p)*_+.5*m,S=p*g-p*_;for(let E=0;E!==a;++E)r[E]=d*o[u+E]+y*o[c+E]+P*o[l+E]+S*o[f+E];return r}},Gl=class extends zs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},Hl=class extends zs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Wl=class extends zs{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let m=(i-t)/(s-t),_=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*_+o[l+g]*m;return r}let h=a*2,p=e-1;for(let m=0;m!==a;++m){let _=o[c+m],g=o[l+m],d=p*h+m*2,y=f[d],P=f[d+1],S=e*h+m*2,E=u[S],b=u[S+1],x=z_(i,t,y,E,s);r[m]=Op(x,_,P,b,g)}return r}};function Op(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function B_(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function z_(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Op(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=B_(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ai=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Xr(t,this.TimeBufferType),this.values=Xr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Xr(e.times,Array),values:Xr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),gl(e.settings)&&(i.settings={inTangents:Xr(e.settings.inTangents,Array),outTangents:Xr(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Hl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Gl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Vl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Wl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Xo:t=this.InterpolantFactoryMethodDiscrete;break;case Pl:t=this.InterpolantFactoryMethodLinear;break;case yl:t=this.InterpolantFactoryMethodSmooth;break;case uu:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Xo;case this.InterpolantFactoryMethodLinear:return Pl;case this.InterpolantFactoryMethodSmooth:return yl;case this.InterpolantFactoryMethodBezier:return uu}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;gl(this.settings)&&(Wd(this.settings.inTangents,e),Wd(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;gl(this.settings)&&(Xd(this.settings.inTangents,e),Xd(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&t_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===yl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,p=f+i;for(let m=0;m!==i;++m){let _=t[f+m];if(_!==t[h+m]||_!==t[p+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let p=0;p!==i;++p)t[h+p]=t[f+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,gl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Wd(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Xd(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}ai.prototype.ValueTypeName="";ai.prototype.TimeBufferType=Float32Array;ai.prototype.ValueBufferType=Float32Array;ai.prototype.DefaultInterpolation=Pl;var ks=class extends ai{constructor(e,t,i){super(e,t,i)}};ks.prototype.ValueTypeName="bool";ks.prototype.ValueBufferType=Array;ks.prototype.DefaultInterpolation=Xo;ks.prototype.InterpolantFactoryMethodLinear=void 0;ks.prototype.InterpolantFactoryMethodSmooth=void 0;var Xl=class extends ai{constructor(e,t,i,s){super(e,t,i,s)}};Xl.prototype.ValueTypeName="color";var ql=class extends ai{constructor(e,t,i,s){super(e,t,i,s)}};ql.prototype.ValueTypeName="number";var Yl=class extends zs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)an.slerpFlat(r,0,o,c-a,o,c,l);return r}},la=class extends ai{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Yl(this.times,this.values,this.getValueSize(),e)}};la.prototype.ValueTypeName="quaternion";la.prototype.InterpolantFactoryMethodSmooth=void 0;var Vs=class extends ai{constructor(e,t,i){super(e,t,i)}};Vs.prototype.ValueTypeName="string";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=Xo;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var $l=class extends ai{constructor(e,t,i,s){super(e,t,i,s)}};$l.prototype.ValueTypeName="vector";var Zl=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let p=c[f],m=c[f+1];if(p.global&&(p.lastIndex=0),p.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Bp=new Zl,Jl=class{constructor(e){this.manager=e!==void 0?e:Bp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Jl.DEFAULT_MATERIAL_NAME="__DEFAULT";var ca=class extends Nn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new rt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var hu=new wt,qd=new G,Yd=new G,Kl=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ye(512,512),this.mapType=jn,this.map=null,this.mapPass=null,this.matrix=new wt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Bs,this._frameExtents=new Ye(1,1),this._viewportCount=1,this._viewports=[new $t(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;qd.setFromMatrixPosition(e.matrixWorld),t.position.copy(qd),Yd.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Yd),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){hu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(hu,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Kr||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(hu)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},_l=new G,xl=new an,Hi=new G,ha=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new wt,this.projectionMatrix=new wt,this.projectionMatrixInverse=new wt,this.coordinateSystem=pi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(_l,xl,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_l,xl,Hi.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(_l,xl,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_l,xl,Hi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Us=new G,$d=new Ye,Zd=new Ye,$n=class extends ha{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Qr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan($r*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Qr*2*Math.atan(Math.tan($r*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Us.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Us.x,Us.y).multiplyScalar(-e/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Us.x,Us.y).multiplyScalar(-e/Us.z)}getViewSize(e,t){return this.getViewBounds(e,$d,Zd),t.subVectors(Zd,$d)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan($r*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ua=class extends ha{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},mu=class extends Kl{constructor(){super(new ua(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},fa=class extends ca{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new mu}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},da=class extends ca{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var qr=-90,Yr=1,oo=class extends Nn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new $n(qr,Yr,e,t);s.layers=this.layers,this.add(s);let r=new $n(qr,Yr,e,t);r.layers=this.layers,this.add(r);let o=new $n(qr,Yr,e,t);o.layers=this.layers,this.add(o);let a=new $n(qr,Yr,e,t);a.layers=this.layers,this.add(a);let l=new $n(qr,Yr,e,t);l.layers=this.layers,this.add(l);let c=new $n(qr,Yr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===pi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Kr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=_,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,p),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},jl=class extends $n{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Ku="\\[\\]\\.:\\/",k_=new RegExp("["+Ku+"]","g"),ju="[^"+Ku+"]",V_="[^"+Ku.replace("\\.","")+"]",G_=/((?:WC+[\/:])*)/.source.replace("WC",ju),H_=/(WCOD+)?/.source.replace("WCOD",V_),W_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",ju),X_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",ju),q_=new RegExp("^"+G_+H_+W_+X_+"$"),Y_=["material","materials","bones","map"],gu=class{constructor(e,t,i){let s=i||Wt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Wt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(k_,"")}static parseTrackName(e){let t=q_.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Y_.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Wt.Composite=gu;Wt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Wt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Wt.prototype.GetterByBindingType=[Wt.prototype._getValue_direct,Wt.prototype._getValue_array,Wt.prototype._getValue_arrayElement,Wt.prototype._getValue_toArray];Wt.prototype.SetterByBindingTypeAndVersioning=[[Wt.prototype._setValue_direct,Wt.prototype._setValue_direct_setNeedsUpdate,Wt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_array,Wt.prototype._setValue_array_setNeedsUpdate,Wt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_arrayElement,Wt.prototype._setValue_arrayElement_setNeedsUpdate,Wt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_fromArray,Wt.prototype._setValue_fromArray_setNeedsUpdate,Wt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var f1=new Float32Array(1);var Jd=new wt,gs=class{constructor(e,t,i=0,s=1/0){this.ray=new Fs(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new to,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Qe("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Jd.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Jd),this}intersectObject(e,t=!0,i=[]){return _u(e,this,i,t),i.sort(Kd),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)_u(e[s],this,i,t);return i.sort(Kd),i}};function Kd(n,e){return n.distance-e.distance}function _u(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)_u(r[o],e,t,!0)}}var ao=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=dt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(dt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var xu=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var pa=class extends ps{constructor(e=10,t=10,i=4473924,s=8947848){i=new rt(i),s=new rt(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let h=0,p=0,m=-a;h<=t;h++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let _=h===r?i:s;_.toArray(c,p),p+=3,_.toArray(c,p),p+=3,_.toArray(c,p),p+=3,_.toArray(c,p),p+=3}let u=new pn;u.setAttribute("position",new Ft(l,3)),u.setAttribute("color",new Ft(c,3));let f=new mi({vertexColors:!0,toneMapped:!1});super(u,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ma=class extends Ti{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Qu(n,e,t,i){let s=$_(i);switch(t){case Ou:return n*e;case zu:return n*e/s.components*s.byteLength;case oc:return n*e/s.components*s.byteLength;case Xs:return n*e*2/s.components*s.byteLength;case ac:return n*e*2/s.components*s.byteLength;case Bu:return n*e*3/s.components*s.byteLength;case Ii:return n*e*4/s.components*s.byteLength;case lc:return n*e*4/s.components*s.byteLength;case xa:case ya:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case va:case Sa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case hc:case fc:return Math.max(n,16)*Math.max(e,8)/4;case cc:case uc:return Math.max(n,8)*Math.max(e,8)/2;case dc:case pc:case gc:case _c:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case mc:case Ma:case xc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case yc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case vc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Sc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Mc:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case bc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case wc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Ec:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Tc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Ac:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Cc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Rc:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Pc:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Ic:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Lc:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Dc:case Nc:case Uc:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Fc:case Oc:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ba:case Bc:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function $_(n){switch(n){case jn:case Du:return{byteLength:1,components:1};case uo:case Nu:case Pi:return{byteLength:2,components:1};case sc:case rc:return{byteLength:2,components:4};case Ci:case ic:case Ri:return{byteLength:4,components:1};case Uu:case Fu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function om(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function J_(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((p,m)=>p.start-m.start);let h=0;for(let p=1;p<f.length;p++){let m=f[h],_=f[p];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++h,f[h]=_)}f.length=h+1;for(let p=0,m=f.length;p<m;p++){let _=f[p];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var K_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,j_=`#ifdef USE_ALPHAHASH
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
#endif`,Q_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,ex=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,tx=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,nx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ix=`#ifdef USE_AOMAP
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
#endif`,sx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,rx=`#ifdef USE_BATCHING
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
#endif`,ox=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ax=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,lx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,cx=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,hx=`#ifdef USE_IRIDESCENCE
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
#endif`,ux=`#ifdef USE_BUMPMAP
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
#endif`,fx=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,dx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,px=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,mx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,gx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,_x=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,xx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,yx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,vx=`#define PI 3.141592653589793
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
} // validated`,Sx=`vec3 transformedNormal = objectNormal;
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
#endif`,Mx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,bx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,wx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Ex=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Tx="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ax=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Cx=`#ifdef USE_ENVMAP
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
#endif`,Rx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Px=`#ifdef USE_ENVMAP
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
#endif`,Ix=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Lx=`#ifdef USE_ENVMAP
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
#endif`,Dx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Nx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ux=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Fx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ox=`#ifdef USE_GRADIENTMAP
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
}`,Bx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,zx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,kx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Vx=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Gx=`#ifdef USE_ENVMAP
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
#endif`,Hx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Wx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Xx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,qx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Yx=`PhysicalMaterial material;
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
#endif`,$x=`uniform sampler2D dfgLUT;
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
}`,Zx=`
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
#endif`,Jx=`#if defined( RE_IndirectDiffuse )
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
#endif`,Kx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,jx=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Qx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ey=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ty=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ny=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,iy=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,sy=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,ry=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,oy=`#if defined( USE_POINTS_UV )
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
#endif`,ay=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ly=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,cy=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,hy=`#if defined( USE_MORPHCOLORS )
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
#endif`,uy=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,fy=`#ifdef USE_MORPHTARGETS
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
#endif`,dy=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,py=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,my=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,gy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_y=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,xy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,yy=`#ifdef USE_NORMALMAP
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
#endif`,vy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Sy=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,My=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,by=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,wy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Ey=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Ty=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ay=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Cy=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Ry=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Py=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Iy=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Ly=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Dy=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Ny=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Uy=`float getShadowMask() {
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
}`,Fy=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Oy=`#ifdef USE_SKINNING
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
#endif`,By=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,zy=`#ifdef USE_SKINNING
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
#endif`,ky=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Vy=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Gy=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Hy=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Wy=`#ifdef USE_TRANSMISSION
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
#endif`,Xy=`#ifdef USE_TRANSMISSION
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
#endif`,qy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Yy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,$y=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Zy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Jy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Ky=`uniform sampler2D t2D;
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
}`,jy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Qy=`uniform float backgroundBlurriness;
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
}`,ev=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,tv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nv=`#include <common>
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
}`,iv=`#if DEPTH_PACKING == 3200
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
}`,sv=`#define DISTANCE
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
}`,rv=`#define DISTANCE
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
}`,ov=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,av=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lv=`uniform float scale;
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
}`,cv=`uniform vec3 diffuse;
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
}`,hv=`#include <common>
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
}`,uv=`uniform vec3 diffuse;
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
}`,fv=`#define LAMBERT
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
}`,dv=`#define LAMBERT
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
}`,pv=`#define MATCAP
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
}`,mv=`#define MATCAP
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
}`,gv=`#define NORMAL
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
}`,_v=`#define NORMAL
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
}`,xv=`#define PHONG
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
}`,yv=`#define PHONG
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
}`,vv=`#define STANDARD
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
}`,Sv=`#define STANDARD
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
}`,Mv=`#define TOON
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
}`,bv=`#define TOON
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
}`,wv=`uniform float size;
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
}`,Ev=`uniform vec3 diffuse;
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
}`,Tv=`#include <common>
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
}`,Av=`uniform vec3 color;
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
}`,Cv=`uniform float rotation;
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
}`,Rv=`uniform vec3 diffuse;
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
}`,ct={alphahash_fragment:K_,alphahash_pars_fragment:j_,alphamap_fragment:Q_,alphamap_pars_fragment:ex,alphatest_fragment:tx,alphatest_pars_fragment:nx,aomap_fragment:ix,aomap_pars_fragment:sx,batching_pars_vertex:rx,batching_vertex:ox,begin_vertex:ax,beginnormal_vertex:lx,bsdfs:cx,iridescence_fragment:hx,bumpmap_pars_fragment:ux,clipping_planes_fragment:fx,clipping_planes_pars_fragment:dx,clipping_planes_pars_vertex:px,clipping_planes_vertex:mx,color_fragment:gx,color_pars_fragment:_x,color_pars_vertex:xx,color_vertex:yx,common:vx,defaultnormal_vertex:Sx,displacementmap_pars_vertex:Mx,displacementmap_vertex:bx,emissivemap_fragment:wx,emissivemap_pars_fragment:Ex,colorspace_fragment:Tx,colorspace_pars_fragment:Ax,envmap_fragment:Cx,envmap_common_pars_fragment:Rx,envmap_pars_fragment:Px,envmap_pars_vertex:Ix,envmap_physical_pars_fragment:Gx,envmap_vertex:Lx,fog_vertex:Dx,fog_pars_vertex:Nx,fog_fragment:Ux,fog_pars_fragment:Fx,gradientmap_pars_fragment:Ox,lightmap_pars_fragment:Bx,lights_lambert_fragment:zx,lights_lambert_pars_fragment:kx,lights_pars_begin:Vx,lights_toon_fragment:Hx,lights_toon_pars_fragment:Wx,lights_phong_fragment:Xx,lights_phong_pars_fragment:qx,lights_physical_fragment:Yx,lights_physical_pars_fragment:$x,lights_fragment_begin:Zx,lights_fragment_maps:Jx,lights_fragment_end:Kx,lightprobes_pars_fragment:jx,logdepthbuf_fragment:Qx,logdepthbuf_pars_fragment:ey,logdepthbuf_pars_vertex:ty,logdepthbuf_vertex:ny,map_fragment:iy,map_pars_fragment:sy,map_particle_fragment:ry,map_particle_pars_fragment:oy,metalnessmap_fragment:ay,metalnessmap_pars_fragment:ly,morphinstance_vertex:cy,morphcolor_vertex:hy,morphnormal_vertex:uy,morphtarget_pars_vertex:fy,morphtarget_vertex:dy,normal_fragment_begin:py,normal_fragment_maps:my,normal_pars_fragment:gy,normal_pars_vertex:_y,normal_vertex:xy,normalmap_pars_fragment:yy,clearcoat_normal_fragment_begin:vy,clearcoat_normal_fragment_maps:Sy,clearcoat_pars_fragment:My,iridescence_pars_fragment:by,opaque_fragment:wy,packing:Ey,premultiplied_alpha_fragment:Ty,project_vertex:Ay,dithering_fragment:Cy,dithering_pars_fragment:Ry,roughnessmap_fragment:Py,roughnessmap_pars_fragment:Iy,shadowmap_pars_fragment:Ly,shadowmap_pars_vertex:Dy,shadowmap_vertex:Ny,shadowmask_pars_fragment:Uy,skinbase_vertex:Fy,skinning_pars_vertex:Oy,skinning_vertex:By,skinnormal_vertex:zy,specularmap_fragment:ky,specularmap_pars_fragment:Vy,tonemapping_fragment:Gy,tonemapping_pars_fragment:Hy,transmission_fragment:Wy,transmission_pars_fragment:Xy,uv_pars_fragment:qy,uv_pars_vertex:Yy,uv_vertex:$y,worldpos_vertex:Zy,background_vert:Jy,background_frag:Ky,backgroundCube_vert:jy,backgroundCube_frag:Qy,cube_vert:ev,cube_frag:tv,depth_vert:nv,depth_frag:iv,distance_vert:sv,distance_frag:rv,equirect_vert:ov,equirect_frag:av,linedashed_vert:lv,linedashed_frag:cv,meshbasic_vert:hv,meshbasic_frag:uv,meshlambert_vert:fv,meshlambert_frag:dv,meshmatcap_vert:pv,meshmatcap_frag:mv,meshnormal_vert:gv,meshnormal_frag:_v,meshphong_vert:xv,meshphong_frag:yv,meshphysical_vert:vv,meshphysical_frag:Sv,meshtoon_vert:Mv,meshtoon_frag:bv,points_vert:wv,points_frag:Ev,shadow_vert:Tv,shadow_frag:Av,sprite_vert:Cv,sprite_frag:Rv},Ue={common:{diffuse:{value:new rt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new Ye(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new rt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new rt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new rt(16777215)},opacity:{value:1},center:{value:new Ye(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},ji={basic:{uniforms:Vn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:ct.meshbasic_vert,fragmentShader:ct.meshbasic_frag},lambert:{uniforms:Vn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new rt(0)},envMapIntensity:{value:1}}]),vertexShader:ct.meshlambert_vert,fragmentShader:ct.meshlambert_frag},phong:{uniforms:Vn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new rt(0)},specular:{value:new rt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ct.meshphong_vert,fragmentShader:ct.meshphong_frag},standard:{uniforms:Vn([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new rt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag},toon:{uniforms:Vn([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new rt(0)}}]),vertexShader:ct.meshtoon_vert,fragmentShader:ct.meshtoon_frag},matcap:{uniforms:Vn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:ct.meshmatcap_vert,fragmentShader:ct.meshmatcap_frag},points:{uniforms:Vn([Ue.points,Ue.fog]),vertexShader:ct.points_vert,fragmentShader:ct.points_frag},dashed:{uniforms:Vn([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ct.linedashed_vert,fragmentShader:ct.linedashed_frag},depth:{uniforms:Vn([Ue.common,Ue.displacementmap]),vertexShader:ct.depth_vert,fragmentShader:ct.depth_frag},normal:{uniforms:Vn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:ct.meshnormal_vert,fragmentShader:ct.meshnormal_frag},sprite:{uniforms:Vn([Ue.sprite,Ue.fog]),vertexShader:ct.sprite_vert,fragmentShader:ct.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ct.background_vert,fragmentShader:ct.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:ct.backgroundCube_vert,fragmentShader:ct.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ct.cube_vert,fragmentShader:ct.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ct.equirect_vert,fragmentShader:ct.equirect_frag},distance:{uniforms:Vn([Ue.common,Ue.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ct.distance_vert,fragmentShader:ct.distance_frag},shadow:{uniforms:Vn([Ue.lights,Ue.fog,{color:{value:new rt(0)},opacity:{value:1}}]),vertexShader:ct.shadow_vert,fragmentShader:ct.shadow_frag}};ji.physical={uniforms:Vn([ji.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new Ye(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new rt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new Ye},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new rt(0)},specularColor:{value:new rt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new Ye},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag};var Vc={r:0,b:0,g:0},Pv=new wt,am=new it;am.set(-1,0,0,0,1,0,0,0,1);function Iv(n,e,t,i,s,r){let o=new rt(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function p(y){let P=y.isScene===!0?y.background:null;if(P&&P.isTexture){let S=y.backgroundBlurriness>0;P=e.get(P,S)}return P}function m(y){let P=!1,S=p(y);S===null?g(o,a):S&&S.isColor&&(g(S,1),P=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||P)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(y,P){let S=p(P);S&&S.isCubeTexture?(c===void 0&&(c=new Et(new Ai(1,1,1),new Zi({name:"BackgroundCubeMaterial",uniforms:fr(ji.backgroundCube.uniforms),vertexShader:ji.backgroundCube.vertexShader,fragmentShader:ji.backgroundCube.fragmentShader,side:Un,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,b,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=P.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Pv.makeRotationFromEuler(P.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(am),c.material.toneMapped=_t.getTransfer(S.colorSpace)!==Ct,(u!==S||f!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Et(new aa(2,2),new Zi({name:"BackgroundMaterial",uniforms:fr(ji.background.uniforms),vertexShader:ji.background.vertexShader,fragmentShader:ji.background.fragmentShader,side:Ws,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,l.material.toneMapped=_t.getTransfer(S.colorSpace)!==Ct,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,P){y.getRGB(Vc,Ju(n)),t.buffers.color.setClear(Vc.r,Vc.g,Vc.b,P,r)}function d(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,P=1){o.set(y),a=P,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:m,addToRenderList:_,dispose:d}}function Lv(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(C,D,F,I,z){let X=!1,B=f(C,I,F,D);r!==B&&(r=B,c(r.object)),X=p(C,I,F,z),X&&m(C,I,F,z),z!==null&&e.update(z,n.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,S(C,D,F,I),z!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(z).buffer))}function l(){return n.createVertexArray()}function c(C){return n.bindVertexArray(C)}function u(C){return n.deleteVertexArray(C)}function f(C,D,F,I){let z=I.wireframe===!0,X=i[D.id];X===void 0&&(X={},i[D.id]=X);let B=C.isInstancedMesh===!0?C.id:0,he=X[B];he===void 0&&(he={},X[B]=he);let Y=he[F.id];Y===void 0&&(Y={},he[F.id]=Y);let ee=Y[z];return ee===void 0&&(ee=h(l()),Y[z]=ee),ee}function h(C){let D=[],F=[],I=[];for(let z=0;z<t;z++)D[z]=0,F[z]=0,I[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:F,attributeDivisors:I,object:C,attributes:{},index:null}}function p(C,D,F,I){let z=r.attributes,X=D.attributes,B=0,he=F.getAttributes();for(let Y in he)if(he[Y].location>=0){let re=z[Y],Q=X[Y];if(Q===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(Q=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(Q=C.instanceColor)),re===void 0||re.attribute!==Q||Q&&re.data!==Q.data)return!0;B++}return r.attributesNum!==B||r.index!==I}function m(C,D,F,I){let z={},X=D.attributes,B=0,he=F.getAttributes();for(let Y in he)if(he[Y].location>=0){let re=X[Y];re===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(re=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(re=C.instanceColor));let Q={};Q.attribute=re,re&&re.data&&(Q.data=re.data),z[Y]=Q,B++}r.attributes=z,r.attributesNum=B,r.index=I}function _(){let C=r.newAttributes;for(let D=0,F=C.length;D<F;D++)C[D]=0}function g(C){d(C,0)}function d(C,D){let F=r.newAttributes,I=r.enabledAttributes,z=r.attributeDivisors;F[C]=1,I[C]===0&&(n.enableVertexAttribArray(C),I[C]=1),z[C]!==D&&(n.vertexAttribDivisor(C,D),z[C]=D)}function y(){let C=r.newAttributes,D=r.enabledAttributes;for(let F=0,I=D.length;F<I;F++)D[F]!==C[F]&&(n.disableVertexAttribArray(F),D[F]=0)}function P(C,D,F,I,z,X,B){B===!0?n.vertexAttribIPointer(C,D,F,z,X):n.vertexAttribPointer(C,D,F,I,z,X)}function S(C,D,F,I){_();let z=I.attributes,X=F.getAttributes(),B=D.defaultAttributeValues;for(let he in X){let Y=X[he];if(Y.location>=0){let ee=z[he];if(ee===void 0&&(he==="instanceMatrix"&&C.instanceMatrix&&(ee=C.instanceMatrix),he==="instanceColor"&&C.instanceColor&&(ee=C.instanceColor)),ee!==void 0){let re=ee.normalized,Q=ee.itemSize,ie=e.get(ee);if(ie===void 0)continue;let Z=ie.buffer,de=ie.type,se=ie.bytesPerElement,ge=de===n.INT||de===n.UNSIGNED_INT||ee.gpuType===ic;if(ee.isInterleavedBufferAttribute){let me=ee.data,W=me.isInterleavedBuffer===!0?me.stride:me.itemSize,ne=ee.offset;if(me.isInstancedInterleavedBuffer||me.isInstancedBufferAttribute){for(let le=0;le<Y.locationSize;le++)d(Y.location+le,me.meshPerAttribute);C.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=me.meshPerAttribute*me.count)}else for(let le=0;le<Y.locationSize;le++)g(Y.location+le);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let le=0;le<Y.locationSize;le++)P(Y.location+le,Q/Y.locationSize,de,re,W*se,(ne+Q/Y.locationSize*le)*se,ge)}else{if(ee.isInstancedBufferAttribute){for(let me=0;me<Y.locationSize;me++)d(Y.location+me,ee.meshPerAttribute);C.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let me=0;me<Y.locationSize;me++)g(Y.location+me);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let me=0;me<Y.locationSize;me++)P(Y.location+me,Q/Y.locationSize,de,re,Q*se,Q/Y.locationSize*me*se,ge)}}else if(B!==void 0){let re=B[he];if(re!==void 0)switch(re.length){case 2:n.vertexAttrib2fv(Y.location,re);break;case 3:n.vertexAttrib3fv(Y.location,re);break;case 4:n.vertexAttrib4fv(Y.location,re);break;default:n.vertexAttrib1fv(Y.location,re)}}}}y()}function E(){N();for(let C in i){let D=i[C];for(let F in D){let I=D[F];for(let z in I){let X=I[z];for(let B in X)u(X[B].object),delete X[B];delete I[z]}}delete i[C]}}function b(C){if(i[C.id]===void 0)return;let D=i[C.id];for(let F in D){let I=D[F];for(let z in I){let X=I[z];for(let B in X)u(X[B].object),delete X[B];delete I[z]}}delete i[C.id]}function x(C){for(let D in i){let F=i[D];for(let I in F){let z=F[I];if(z[C.id]===void 0)continue;let X=z[C.id];for(let B in X)u(X[B].object),delete X[B];delete z[C.id]}}}function M(C){for(let D in i){let F=i[D],I=C.isInstancedMesh===!0?C.id:0,z=F[I];if(z!==void 0){for(let X in z){let B=z[X];for(let he in B)u(B[he].object),delete B[he];delete z[X]}delete F[I],Object.keys(F).length===0&&delete i[D]}}}function N(){A(),o=!0,r!==s&&(r=s,c(r.object))}function A(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:A,dispose:E,releaseStatesOfGeometry:b,releaseStatesOfObject:M,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:g,disableUnusedAttributes:y}}function Dv(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let p=0;p<u;p++)h+=c[p];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Nv(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Ii&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let M=x===Pi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==jn&&x!==Ri&&!M&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),d=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),P=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),b=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:g,maxAttributes:d,maxVertexUniforms:y,maxVaryings:P,maxFragmentUniforms:S,maxSamples:E,samples:b}}function Uv(n){let e=this,t=null,i=0,s=!1,r=!1,o=new In,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let p=f.length!==0||h||i!==0||s;return s=h,i=f.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,p){let m=f.clippingPlanes,_=f.clipIntersection,g=f.clipShadows,d=n.get(f);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let y=r?0:i,P=y*4,S=d.clippingState||null;l.value=S,S=u(m,h,P,p);for(let E=0;E!==P;++E)S[E]=t[E];d.clippingState=S,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,p,m){let _=f!==null?f.length:0,g=null;if(_!==0){if(g=l.value,m!==!0||g===null){let d=p+_*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<d)&&(g=new Float32Array(d));for(let P=0,S=p;P!==_;++P,S+=4)o.copy(f[P]).applyMatrix4(y,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,g}}var Ta=class extends oi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new na(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ai(5,5,5),r=new Zi({name:"CubemapFromEquirect",uniforms:fr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Un,blending:lr});r.uniforms.tEquirect.value=t;let o=new Et(s,r),a=t.minFilter;return t.minFilter===_s&&(t.minFilter=Dn),new oo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},zp=256,Fv=3,Ov=20,lm=256,cm=16,Bv=3,zv=new G,kv=new rt,Hc=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new oo(1,10,null),this._boxMesh=new Et(new Ai(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=zv}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,p=l.autoClearDepth,m=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(kv));let g=new oo(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=p,l.autoClearStencil=m,e.background=_,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Gp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Vp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(zp,qu(e))}_fromTexture(e,t){e.mapping===hr||e.mapping===ho?this._setSize(e.image.length===0?zp:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=kp(e,!1,!1),i=Math.log2(e)-Fv;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=kp(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===hr||e.mapping===ho?(this._cubemapMaterial===null&&(this._cubemapMaterial=Gp()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Vp()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Vv(),this._integrationMaterial=Gv());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/cm);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Bv)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(lm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Hv());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function kp(n,e,t){return new Ta(n,{minFilter:_s,generateMipmaps:e,type:Pi,colorSpace:qo,depthBuffer:t})}function Aa(n,e,t){return new Zi({name:n,uniforms:e,vertexShader:ct.cube_vert,fragmentShader:t,side:Un,blending:lr,depthTest:!1,depthWrite:!1})}function Vv(){return Aa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${lm}u

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
	`)}function Gv(){return Aa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:cm}},`

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
	`)}function Hv(){return Aa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Ov}
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
	`)}function Vp(){return Aa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Gp(){return Aa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Wv(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,p=!1){return h==null?null:p?o(h):r(h)}function r(h){if(h&&h.isTexture){let p=h.mapping;if(p===ec||p===tc)if(e.has(h)){let m=e.get(h).texture;return a(m,h.mapping)}else{let m=h.image;if(m&&m.height>0){let _=new Ta(m.height);return _.fromEquirectangularTexture(n,h),e.set(h,_),h.addEventListener("dispose",c),a(_.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let p=h.mapping,m=p===ec||p===tc,_=p===hr||p===ho;if(m||_){let g=t.get(h),d=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==d)return i===null&&(i=new Hc(n)),g=m?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let y=h.image;return m&&y&&y.height>0||_&&y&&l(y)?(i===null&&(i=new Hc(n)),g=m?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,p){return p===ec?h.mapping=hr:p===tc&&(h.mapping=ho),h}function l(h){let p=0,m=6;for(let _=0;_<m;_++)h[_]!==void 0&&p++;return p===m}function c(h){let p=h.target;p.removeEventListener("dispose",c);let m=e.get(p);m!==void 0&&(e.delete(p),m.dispose())}function u(h){let p=h.target;p.removeEventListener("dispose",u);let m=t.get(p);m!==void 0&&(t.delete(p),m.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function Xv(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Ho("WebGLRenderer: "+i+" extension not supported."),s}}}function qv(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let g in m.attributes)e.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let _=r.get(m);_&&(e.remove(_),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function u(m){let _=m.attributes;for(let g in _)e.update(_[g],n.ARRAY_BUFFER)}function f(m){let _=m.index,g=m.attributes.position,d=0;if(g===void 0)return;let y=_!==null?_.array.length:g.array.length/3-1,P=g.count>=65535?Qo:jo,S=new P(Math.ceil(y/3)*6,1),E=S.array;if(_!==null){let x=_.array;d=_.version;for(let M=0,N=0;M<y;M+=3){let A=x[M+0],C=x[M+1],D=x[M+2];E[N++]=A,E[N++]=C,E[N++]=C,E[N++]=D,E[N++]=D,E[N++]=A}}else{d=g.version;for(let x=0,M=0;x<y;x+=3){let N=x+0,A=x+1,C=x+2;E[M++]=N,E[M++]=A,E[M++]=A,E[M++]=C,E[M++]=C,E[M++]=N}}S.version=d;let b=r.get(m);b&&e.remove(b),r.set(m,S)}function h(m){let _=r.get(m);if(_){let g=m.index;g!==null&&_.version<g.version&&f(m)}else f(m);return r.get(m)}function p(){for(let m in s){let _=s[m].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:h,dispose:p}}function Yv(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,p){p!==0&&(n.drawElementsInstanced(i,h,r,f*o,p),t.update(h,i,p))}function u(f,h,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,p);let _=0;for(let g=0;g<p;g++)_+=h[g];t.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function $v(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function Zv(n,e,t){let i=new WeakMap,s=new $t;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let N=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",N)};h!==void 0&&h.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],P=0;p===!0&&(P=1),m===!0&&(P=2),_===!0&&(P=3);let S=a.attributes.position.count*P,E=1;S>e.maxTextureSize&&(E=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let b=new Float32Array(S*E*4*f),x=new Jo(b,S,E,f);x.type=Ri,x.needsUpdate=!0;let M=P*4;for(let A=0;A<f;A++){let C=g[A],D=d[A],F=y[A],I=S*E*4*A;for(let z=0;z<C.count;z++){let X=z*M;p===!0&&(s.fromBufferAttribute(C,z),b[I+X+0]=s.x,b[I+X+1]=s.y,b[I+X+2]=s.z,b[I+X+3]=0),m===!0&&(s.fromBufferAttribute(D,z),b[I+X+4]=s.x,b[I+X+5]=s.y,b[I+X+6]=s.z,b[I+X+7]=0),_===!0&&(s.fromBufferAttribute(F,z),b[I+X+8]=s.x,b[I+X+9]=s.y,b[I+X+10]=s.z,b[I+X+11]=F.itemSize===4?s.w:1)}}h={count:f,texture:x,size:new Ye(S,E)},i.set(a,h),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let _=0;_<c.length;_++)p+=c[_];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function Jv(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var Kv={[Eu]:"LINEAR_TONE_MAPPING",[Tu]:"REINHARD_TONE_MAPPING",[Au]:"CINEON_TONE_MAPPING",[Cu]:"ACES_FILMIC_TONE_MAPPING",[Pu]:"AGX_TONE_MAPPING",[Iu]:"NEUTRAL_TONE_MAPPING",[Ru]:"CUSTOM_TONE_MAPPING"};function jv(n,e,t,i,s,r){let o=new oi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new pn;u.setAttribute("position",new Ft([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ft([0,2,0,0,2,0],2));let f=new Bl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new Et(u,f),p=new ua(-1,1,1,-1,0,1),m=null,_=null,g=!1,d,y=null,P=[],S=!1;this.setSize=function(E,b){o.setSize(E,b),a!==null&&a.setSize(E,b),l!==null&&l.setSize(E,b);for(let x=0;x<P.length;x++){let M=P[x];M.setSize&&M.setSize(E,b)}},this.setEffects=function(E){P=E,S=P.length>0&&P[0].isRenderPass===!0;let b=o.width,x=o.height;P.length>0&&a===null&&(a=new oi(b,x,{type:Pi,depthBuffer:!1,stencilBuffer:!1}),l=new oi(b,x,{type:Pi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&P.some(N=>N.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new ms(b,x),r===!0&&(c.format=xs,c.type=ur)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let N=0;N<P.length;N++){let A=P[N];A.setSize&&A.setSize(b,x),M&&A.needsDepthTexture===!0&&A.setDepthTexture&&A.setDepthTexture(c)}},this.begin=function(E,b){if(g||E.toneMapping===Ji&&P.length===0)return!1;if(y=b,b!==null){let x=b.width,M=b.height;(o.width!==x||o.height!==M)&&this.setSize(x,M)}return S===!1&&E.setRenderTarget(o),d=E.toneMapping,E.toneMapping=Ji,!0},this.hasRenderPass=function(){return S},this.end=function(E,b){E.toneMapping=d,g=!0;let x=o,M=a;for(let N=0;N<P.length;N++){let A=P[N];A.enabled!==!1&&(A.render(E,M,x,b),A.needsSwap!==!1&&(x=M,M=M===a?l:a))}if(m!==E.outputColorSpace||_!==E.toneMapping){m=E.outputColorSpace,_=E.toneMapping,f.defines={},_t.getTransfer(m)===Ct&&(f.defines.SRGB_TRANSFER="");let N=Kv[_];N&&(f.defines[N]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,E.setRenderTarget(y),E.render(h,p),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var hm=new Zn,um=new ms(1,1),fm=new sa(1),dm=new Jo,pm=new Dl,mm=new na,Hp=[],Wp=[],Xp=new Float32Array(16),qp=new Float32Array(9),Yp=new Float32Array(4);function po(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Hp[s];if(r===void 0&&(r=new Float32Array(s),Hp[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function yn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function vn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Xc(n,e){let t=Wp[e];t===void 0&&(t=new Int32Array(e),Wp[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function Qv(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function eS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;n.uniform2fv(this.addr,e),vn(t,e)}}function tS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(yn(t,e))return;n.uniform3fv(this.addr,e),vn(t,e)}}function nS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;n.uniform4fv(this.addr,e),vn(t,e)}}function iS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(yn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,i))return;Yp.set(i),n.uniformMatrix2fv(this.addr,!1,Yp),vn(t,i)}}function sS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(yn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,i))return;qp.set(i),n.uniformMatrix3fv(this.addr,!1,qp),vn(t,i)}}function rS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(yn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,i))return;Xp.set(i),n.uniformMatrix4fv(this.addr,!1,Xp),vn(t,i)}}function oS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function aS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;n.uniform2iv(this.addr,e),vn(t,e)}}function lS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yn(t,e))return;n.uniform3iv(this.addr,e),vn(t,e)}}function cS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;n.uniform4iv(this.addr,e),vn(t,e)}}function hS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function uS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;n.uniform2uiv(this.addr,e),vn(t,e)}}function fS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yn(t,e))return;n.uniform3uiv(this.addr,e),vn(t,e)}}function dS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;n.uniform4uiv(this.addr,e),vn(t,e)}}function qc(n){return n.version===0&&(n.compareFunction=Gu,n.needsUpdate=!0),n}function pS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=qc(um):r=hm,t.setTexture2D(e||r,s)}function mS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||pm,s)}function gS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=qc(fm):r=mm,t.setTextureCube(e||r,s)}function _S(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||dm,s)}function xS(n){switch(n){case 5126:return Qv;case 35664:return eS;case 35665:return tS;case 35666:return nS;case 35674:return iS;case 35675:return sS;case 35676:return rS;case 5124:case 35670:return oS;case 35667:case 35671:return aS;case 35668:case 35672:return lS;case 35669:case 35673:return cS;case 5125:return hS;case 36294:return uS;case 36295:return fS;case 36296:return dS;case 35678:case 36198:case 36298:case 36306:case 35682:return pS;case 35679:case 36299:case 36307:return mS;case 35680:case 36300:case 36308:case 36293:return gS;case 36289:case 36303:case 36311:case 36292:return _S}}function yS(n,e){n.uniform1fv(this.addr,e)}function vS(n,e){let t=po(e,this.size,2);n.uniform2fv(this.addr,t)}function SS(n,e){let t=po(e,this.size,3);n.uniform3fv(this.addr,t)}function MS(n,e){let t=po(e,this.size,4);n.uniform4fv(this.addr,t)}function bS(n,e){let t=po(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function wS(n,e){let t=po(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function ES(n,e){let t=po(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function TS(n,e){n.uniform1iv(this.addr,e)}function AS(n,e){n.uniform2iv(this.addr,e)}function CS(n,e){n.uniform3iv(this.addr,e)}function RS(n,e){n.uniform4iv(this.addr,e)}function PS(n,e){n.uniform1uiv(this.addr,e)}function IS(n,e){n.uniform2uiv(this.addr,e)}function LS(n,e){n.uniform3uiv(this.addr,e)}function DS(n,e){n.uniform4uiv(this.addr,e)}function NS(n,e,t){let i=this.cache,s=e.length,r=Xc(t,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=qc(um):o=hm;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function US(n,e,t){let i=this.cache,s=e.length,r=Xc(t,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||pm,r[o])}function FS(n,e,t){let i=this.cache,s=e.length,r=Xc(t,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=qc(fm):o=mm;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function OS(n,e,t){let i=this.cache,s=e.length,r=Xc(t,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||dm,r[o])}function BS(n){switch(n){case 5126:return yS;case 35664:return vS;case 35665:return SS;case 35666:return MS;case 35674:return bS;case 35675:return wS;case 35676:return ES;case 5124:case 35670:return TS;case 35667:case 35671:return AS;case 35668:case 35672:return CS;case 35669:case 35673:return RS;case 5125:return PS;case 36294:return IS;case 36295:return LS;case 36296:return DS;case 35678:case 36198:case 36298:case 36306:case 35682:return NS;case 35679:case 36299:case 36307:return US;case 35680:case 36300:case 36308:case 36293:return FS;case 36289:case 36303:case 36311:case 36292:return OS}}var nf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=xS(t.type)}},sf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=BS(t.type)}},rf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},ef=/(\w+)(\])?(\[|\.)?/g;function $p(n,e){n.seq.push(e),n.map[e.id]=e}function zS(n,e,t){let i=n.name,s=i.length;for(ef.lastIndex=0;;){let r=ef.exec(i),o=ef.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){$p(t,c===void 0?new nf(a,n,e):new sf(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new rf(a),$p(t,f)),t=f}}}var fo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);zS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Zp(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var kS=37297,VS=0;function GS(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Jp=new it;function HS(n){_t._getMatrix(Jp,_t.workingColorSpace,n);let e=`mat3( ${Jp.elements.map(t=>t.toFixed(4))} )`;switch(_t.getTransfer(n)){case Yo:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Kp(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+GS(n.getShaderSource(e),a)}else return r}function WS(n,e){let t=HS(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var XS={[Eu]:"Linear",[Tu]:"Reinhard",[Au]:"Cineon",[Cu]:"ACESFilmic",[Pu]:"AgX",[Iu]:"Neutral",[Ru]:"Custom"};function qS(n,e){let t=XS[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Gc=new G;function YS(){_t.getLuminanceCoefficients(Gc);let n=Gc.x.toFixed(4),e=Gc.y.toFixed(4),t=Gc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function $S(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ea).join(`
`)}function ZS(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function JS(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ea(n){return n!==""}function jp(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Qp(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var KS=/^[ \t]*#include +<([\w\d./]+)>/gm;function of(n){return n.replace(KS,jS)}function jS(n,e){let t=ct[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return of(t)}var QS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function em(n){return n.replace(QS,eM)}function eM(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function tm(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var tM={[ga]:"SHADOWMAP_TYPE_PCF",[lo]:"SHADOWMAP_TYPE_VSM"};function nM(n){return tM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var iM={[ho]:"ENVMAP_MODE_REFRACTION"};function sM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":iM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var rM={[Ql]:"ENVMAP_BLENDING_MULTIPLY",[yp]:"ENVMAP_BLENDING_MIX",[vp]:"ENVMAP_BLENDING_ADD"};function oM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":rM[n.combine]||"ENVMAP_BLENDING_NONE"}function aM(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=nM(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=sM(t),f=oM(t),h=$S(t),p=ZS(r),m=s.createProgram(),_,g,d=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Ea).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Ea).join(`
`),g.length>0&&(g+=`
`)):(_=[tm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ea).join(`
`),g=[tm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ji?"#define TONE_MAPPING":"",t.toneMapping!==Ji?ct.tonemapping_pars_fragment:"",t.toneMapping!==Ji?qS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ct.colorspace_pars_fragment,WS("linearToOutputTexel",t.outputColorSpace),YS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ea).join(`
`)),o=of(o),o=jp(o,t),o=Qp(o,t),a=of(a),a=jp(a,t),a=Qp(a,t),o=em(o),a=em(a),t.isRawShaderMaterial!==!0&&(d=`#version 300 es
`,_=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",t.glslVersion===Wu?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Wu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=d+_+o,P=d+g+a,S=Zp(s,s.VERTEX_SHADER,y),E=Zp(s,s.FRAGMENT_SHADER,P);s.attachShader(m,S),s.attachShader(m,E),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function b(A){if(n.debug.checkShaderErrors){let C=s.getProgramInfoLog(m)||"",D=s.getShaderInfoLog(S)||"",F=s.getShaderInfoLog(E)||"",I=C.trim(),z=D.trim(),X=F.trim(),B=!0,he=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(B=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,S,E);else{let Y=Kp(s,S,"vertex"),ee=Kp(s,E,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+A.name+`
Material Type: `+A.type+`

Program Info Log: `+I+`
`+Y+`
`+ee)}else I!==""?Je("WebGLProgram: Program Info Log:",I):(z===""||X==="")&&(he=!1);he&&(A.diagnostics={runnable:B,programLog:I,vertexShader:{log:z,prefix:_},fragmentShader:{log:X,prefix:g}})}s.deleteShader(S),s.deleteShader(E),x=new fo(s,m),M=JS(s,m)}let x;this.getUniforms=function(){return x===void 0&&b(this),x};let M;this.getAttributes=function(){return M===void 0&&b(this),M};let N=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(m,kS)),N},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=VS++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=E,this}var lM=0,af=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new lf(e),t.set(e,i)),i}},lf=class{constructor(e){this.id=lM++,this.code=e,this.usedTimes=0}};function cM(n){return n===Xs||n===Ma||n===ba}function hM(n,e,t,i,s,r){let o=new to,a=new af,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return l.add(x),x===0?"uv":`uv${x}`}function m(x,M,N,A,C,D){let F=A.fog,I=C.geometry,z=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?A.environment:null,X=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,B=e.get(x.envMap||z,X),he=h[x.type],Y=i.precision;x.precision!==null&&(Y=i.getMaxPrecision(x.precision),Y!==x.precision&&Je("WebGLProgram.getParameters:",x.precision,"not supported, using",Y,"instead."));let ee=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,re=ee!==void 0?ee.length:0,Q=0;I.morphAttributes.position!==void 0&&(Q=1),I.morphAttributes.normal!==void 0&&(Q=2),I.morphAttributes.color!==void 0&&(Q=3);let ie,Z,de,se;if(he){let Pe=ji[he];ie=Pe.vertexShader,Z=Pe.fragmentShader}else{ie=x.vertexShader,Z=x.fragmentShader;let Pe=a.getVertexShaderStage(x),at=a.getFragmentShaderStage(x);a.update(x,Pe,at),de=Pe.id,se=at.id}let ge=n.getRenderTarget(),me=n.state.buffers.depth.getReversed(),W=C.isInstancedMesh===!0,ne=C.isBatchedMesh===!0,le=!!x.map,De=!!x.matcap,Oe=!!B,Xe=Oe&&B.isPMREMTexture===!0,ht=!!x.aoMap,yt=!!x.lightMap,zt=!!x.bumpMap&&x.wireframe===!1,vt=!!x.normalMap,Kt=!!x.displacementMap,mt=!!x.emissiveMap,sn=!!x.metalnessMap,Nt=!!x.roughnessMap,jt=x.anisotropy>0,V=x.clearcoat>0,Ie=x.diffuseRoughness>0,Ke=x.dispersion>0,ot=x.retroreflectivity>0,Te=x.iridescence>0,Ut=x.sheen>0,We=x.transmission>0,Ze=jt&&!!x.anisotropyMap,L=V&&!!x.clearcoatMap,w=V&&!!x.clearcoatNormalMap,$=V&&!!x.clearcoatRoughnessMap,xe=Ie&&!!x.diffuseRoughnessMap,fe=Te&&!!x.iridescenceMap,Me=Te&&!!x.iridescenceThicknessMap,be=Ut&&!!x.sheenColorMap,oe=Ut&&!!x.sheenRoughnessMap,ce=!!x.specularMap,ve=!!x.specularColorMap,k=!!x.specularIntensityMap,ue=We&&!!x.transmissionMap,ae=We&&!!x.thicknessMap,Ae=!!x.gradientMap,Se=!!x.alphaMap,Ee=x.alphaTest>0,qe=!!x.alphaHash,et=!!x.extensions,_e=Ji;x.toneMapped&&(ge===null||ge.isXRRenderTarget===!0)&&(_e=n.toneMapping);let Ve=Xe?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,tt={shaderID:he,shaderType:x.type,shaderName:x.name,vertexShader:ie,fragmentShader:Z,defines:x.defines,customVertexShaderID:de,customFragmentShaderID:se,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Y,batching:ne,batchingColor:ne&&C._colorsTexture!==null,instancing:W,instancingColor:W&&C.instanceColor!==null,instancingMorph:W&&C.morphTexture!==null,outputColorSpace:ge===null?n.outputColorSpace:ge.isXRRenderTarget===!0?ge.texture.colorSpace:_t.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:le,matcap:De,envMap:Oe,envMapMode:Oe&&B.mapping,envMapPMREM:Xe,envMapMaxLod:Xe?Ve.length-1:null,envMapSize:Xe?Ve[0].width:null,aoMap:ht,lightMap:yt,bumpMap:zt,normalMap:vt,displacementMap:Kt,emissiveMap:mt,normalMapObjectSpace:vt&&x.normalMapType===bp,normalMapTangentSpace:vt&&x.normalMapType===zc,packedNormalMap:vt&&x.normalMapType===zc&&cM(x.normalMap.format),metalnessMap:sn,roughnessMap:Nt,anisotropy:jt,anisotropyMap:Ze,clearcoat:V,clearcoatMap:L,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:Ie,diffuseRoughnessMap:xe,dispersion:Ke,retroreflection:ot,iridescence:Te,iridescenceMap:fe,iridescenceThicknessMap:Me,sheen:Ut,sheenColorMap:be,sheenRoughnessMap:oe,specularMap:ce,specularColorMap:ve,specularIntensityMap:k,transmission:We,transmissionMap:ue,thicknessMap:ae,gradientMap:Ae,opaque:x.transparent===!1&&x.blending===co&&x.alphaToCoverage===!1,alphaMap:Se,alphaTest:Ee,alphaHash:qe,combine:x.combine,mapUv:le&&p(x.map.channel),aoMapUv:ht&&p(x.aoMap.channel),lightMapUv:yt&&p(x.lightMap.channel),bumpMapUv:zt&&p(x.bumpMap.channel),normalMapUv:vt&&p(x.normalMap.channel),displacementMapUv:Kt&&p(x.displacementMap.channel),emissiveMapUv:mt&&p(x.emissiveMap.channel),metalnessMapUv:sn&&p(x.metalnessMap.channel),roughnessMapUv:Nt&&p(x.roughnessMap.channel),anisotropyMapUv:Ze&&p(x.anisotropyMap.channel),clearcoatMapUv:L&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:w&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:xe&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:fe&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:Me&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:be&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:oe&&p(x.sheenRoughnessMap.channel),specularMapUv:ce&&p(x.specularMap.channel),specularColorMapUv:ve&&p(x.specularColorMap.channel),specularIntensityMapUv:k&&p(x.specularIntensityMap.channel),transmissionMapUv:ue&&p(x.transmissionMap.channel),thicknessMapUv:ae&&p(x.thicknessMap.channel),alphaMapUv:Se&&p(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(vt||jt),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!I.attributes.uv&&(le||Se),fog:!!F,useFog:x.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&vt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:me,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:re,morphTextureStride:Q,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:D.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&N.length>0,shadowMapType:n.shadowMap.type,toneMapping:_e,decodeVideoTexture:le&&x.map.isVideoTexture===!0&&_t.getTransfer(x.map.colorSpace)===Ct,decodeVideoTextureEmissive:mt&&x.emissiveMap.isVideoTexture===!0&&_t.getTransfer(x.emissiveMap.colorSpace)===Ct,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===gi,flipSided:x.side===Un,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:et&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&x.extensions.multiDraw===!0||ne)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function _(x){let M=[];if(x.shaderID?M.push(x.shaderID):(M.push(x.customVertexShaderID),M.push(x.customFragmentShaderID)),x.defines!==void 0)for(let N in x.defines)M.push(N),M.push(x.defines[N]);return x.isRawShaderMaterial===!1&&(g(M,x),d(M,x),M.push(n.outputColorSpace)),M.push(x.customProgramCacheKey),M.join()}function g(x,M){x.push(M.precision),x.push(M.outputColorSpace),x.push(M.envMapMode),x.push(M.envMapPMREM),x.push(M.envMapMaxLod),x.push(M.envMapSize),x.push(M.mapUv),x.push(M.alphaMapUv),x.push(M.lightMapUv),x.push(M.aoMapUv),x.push(M.bumpMapUv),x.push(M.normalMapUv),x.push(M.displacementMapUv),x.push(M.emissiveMapUv),x.push(M.metalnessMapUv),x.push(M.roughnessMapUv),x.push(M.anisotropyMapUv),x.push(M.clearcoatMapUv),x.push(M.clearcoatNormalMapUv),x.push(M.clearcoatRoughnessMapUv),x.push(M.diffuseRoughnessMapUv),x.push(M.iridescenceMapUv),x.push(M.iridescenceThicknessMapUv),x.push(M.sheenColorMapUv),x.push(M.sheenRoughnessMapUv),x.push(M.specularMapUv),x.push(M.specularColorMapUv),x.push(M.specularIntensityMapUv),x.push(M.transmissionMapUv),x.push(M.thicknessMapUv),x.push(M.combine),x.push(M.fogExp2),x.push(M.sizeAttenuation),x.push(M.morphTargetsCount),x.push(M.numSunLights),x.push(M.numDirLights),x.push(M.numPointLights),x.push(M.numSpotLights),x.push(M.numSpotLightMaps),x.push(M.numHemiLights),x.push(M.numRectAreaLights),x.push(M.numSunLightShadows),x.push(M.numDirLightShadows),x.push(M.numPointLightShadows),x.push(M.numSpotLightShadows),x.push(M.numSpotLightShadowsWithMaps),x.push(M.numLightProbes),x.push(M.numLightProbeGrids),x.push(M.shadowMapType),x.push(M.toneMapping),x.push(M.numClippingPlanes),x.push(M.numClipIntersection),x.push(M.depthPacking)}function d(x,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let M=h[x.type],N;if(M){let A=ji[M];N=Fp.clone(A.uniforms)}else N=x.uniforms;return N}function P(x,M){let N=u.get(M);return N!==void 0?++N.usedTimes:(N=new aM(n,M,x,s),c.push(N),u.set(M,N)),N}function S(x){if(--x.usedTimes===0){let M=c.indexOf(x);c[M]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function E(x){a.remove(x)}function b(){a.dispose()}return{getParameters:m,getProgramCacheKey:_,getUniforms:y,acquireProgram:P,releaseProgram:S,releaseShaderCache:E,programs:c,dispose:b}}function uM(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function fM(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function nm(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function im(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let p=0;return h.isInstancedMesh&&(p+=2),h.isSkinnedMesh&&(p+=1),p}function a(h,p,m,_,g,d){let y=n[e];return y===void 0?(y={id:h.id,object:h,geometry:p,material:m,materialVariant:o(h),groupOrder:_,renderOrder:h.renderOrder,z:g,group:d},n[e]=y):(y.id=h.id,y.object=h,y.geometry=p,y.material=m,y.materialVariant=o(h),y.groupOrder=_,y.renderOrder=h.renderOrder,y.z=g,y.group=d),e++,y}function l(h,p,m,_,g,d,y){y.reversedDepth===!0&&(g=-g);let P=a(h,p,m,_,g,d);m.transmission>0?i.push(P):m.transparent===!0?s.push(P):t.push(P)}function c(h,p,m,_,g,d){let y=a(h,p,m,_,g,d);m.transmission>0?i.unshift(y):m.transparent===!0?s.unshift(y):t.unshift(y)}function u(h,p){t.length>1&&t.sort(h||fM),i.length>1&&i.sort(p||nm),s.length>1&&s.sort(p||nm)}function f(){for(let h=e,p=n.length;h<p;h++){let m=n[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function dM(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new im,n.set(i,[o])):s>=r.length?(o=new im,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function pM(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new rt};break;case"SpotLight":t={position:new G,direction:new G,color:new rt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new rt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new rt,groundColor:new rt};break;case"RectAreaLight":t={color:new rt,position:new G,halfWidth:new G,halfHeight:new G};break}return n[e.id]=t,t}}}function mM(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ye};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ye};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ye,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var gM=0;function _M(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function xM(n){let e=new pM,t=mM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new wt,o=new wt;function a(c){let u=0,f=0,h=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let p=0,m=0,_=0,g=0,d=0,y=0,P=0,S=0,E=0,b=0,x=0,M=0,N=0,A=0;c.sort(_M);for(let D=0,F=c.length;D<F;D++){let I=c[D],z=I.color,X=I.intensity,B=I.distance,he=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Xs?he=I.shadow.map.texture:he=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=z.r*X,f+=z.g*X,h+=z.b*X;else if(I.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(I.sh.coefficients[Y],X);A++}else if(I.isSunLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let ee=I.shadow,re=t.get(I);re.shadowIntensity=ee.intensity,re.shadowBias=ee.bias,re.shadowNormalBias=ee.normalBias,re.shadowRadius=ee.radius,re.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),i.sunShadow[m]=re,i.sunShadowMap[m]=he;let Q=ee.getViewportCount();for(let ie=0;ie<Q;ie++)i.sunShadowMatrix[_+ie]=ee.getMatrix(ie),i.sunShadowCascade[_+ie]=ee._cascadeData[ie];_+=Q,m++}i.sun[p]=Y,p++}else if(I.isDirectionalLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let ee=I.shadow,re=t.get(I);re.shadowIntensity=ee.intensity,re.shadowBias=ee.bias,re.shadowNormalBias=ee.normalBias,re.shadowRadius=ee.radius,re.shadowMapSize=ee.mapSize,i.directionalShadow[g]=re,i.directionalShadowMap[g]=he,i.directionalShadowMatrix[g]=I.shadow.matrix,E++}i.directional[g]=Y,g++}else if(I.isSpotLight){let Y=e.get(I);Y.position.setFromMatrixPosition(I.matrixWorld),Y.color.copy(z).multiplyScalar(X),Y.distance=B,Y.coneCos=Math.cos(I.angle),Y.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Y.decay=I.decay,i.spot[y]=Y;let ee=I.shadow;if(I.map&&(i.spotLightMap[M]=I.map,M++,ee.updateMatrices(I),I.castShadow&&N++),i.spotLightMatrix[y]=ee.matrix,I.castShadow){let re=t.get(I);re.shadowIntensity=ee.intensity,re.shadowBias=ee.bias,re.shadowNormalBias=ee.normalBias,re.shadowRadius=ee.radius,re.shadowMapSize=ee.mapSize,i.spotShadow[y]=re,i.spotShadowMap[y]=he,x++}y++}else if(I.isRectAreaLight){let Y=e.get(I);Y.color.copy(z).multiplyScalar(X),Y.halfWidth.set(I.width*.5,0,0),Y.halfHeight.set(0,I.height*.5,0),i.rectArea[P]=Y,P++}else if(I.isPointLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),Y.distance=I.distance,Y.decay=I.decay,I.castShadow){let ee=I.shadow,re=t.get(I);re.shadowIntensity=ee.intensity,re.shadowBias=ee.bias,re.shadowNormalBias=ee.normalBias,re.shadowRadius=ee.radius,re.shadowMapSize=ee.mapSize,re.shadowCameraNear=ee.camera.near,re.shadowCameraFar=ee.camera.far,i.pointShadow[d]=re,i.pointShadowMap[d]=he,i.pointShadowMatrix[d]=I.shadow.matrix,b++}i.point[d]=Y,d++}else if(I.isHemisphereLight){let Y=e.get(I);Y.skyColor.copy(I.color).multiplyScalar(X),Y.groundColor.copy(I.groundColor).multiplyScalar(X),i.hemi[S]=Y,S++}}P>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ue.LTC_FLOAT_1,i.rectAreaLTC2=Ue.LTC_FLOAT_2):(i.rectAreaLTC1=Ue.LTC_HALF_1,i.rectAreaLTC2=Ue.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let C=i.hash;(C.sunLength!==p||C.directionalLength!==g||C.pointLength!==d||C.spotLength!==y||C.rectAreaLength!==P||C.hemiLength!==S||C.numSunShadows!==m||C.numDirectionalShadows!==E||C.numPointShadows!==b||C.numSpotShadows!==x||C.numSpotMaps!==M||C.numLightProbes!==A)&&(i.sun.length=p,i.directional.length=g,i.spot.length=y,i.rectArea.length=P,i.point.length=d,i.hemi.length=S,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=b,i.pointShadowMap.length=b,i.pointShadowMatrix.length=b,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+M-N,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=N,i.numLightProbes=A,C.sunLength=p,C.directionalLength=g,C.pointLength=d,C.spotLength=y,C.rectAreaLength=P,C.hemiLength=S,C.numSunShadows=m,C.numDirectionalShadows=E,C.numPointShadows=b,C.numSpotShadows=x,C.numSpotMaps=M,C.numLightProbes=A,i.version=gM++)}function l(c,u){let f=0,h=0,p=0,m=0,_=0,g=0,d=u.matrixWorldInverse;for(let y=0,P=c.length;y<P;y++){let S=c[y];if(S.isSunLight){let E=i.sun[f];E.direction.setFromMatrixPosition(S.matrixWorld),E.direction.transformDirection(d),f++}else if(S.isDirectionalLight){let E=i.directional[h];E.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(d),h++}else if(S.isSpotLight){let E=i.spot[m];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(d),E.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(d),m++}else if(S.isRectAreaLight){let E=i.rectArea[_];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(d),o.identity(),r.copy(S.matrixWorld),r.premultiply(d),o.extractRotation(r),E.halfWidth.set(S.width*.5,0,0),E.halfHeight.set(0,S.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),_++}else if(S.isPointLight){let E=i.point[p];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(d),p++}else if(S.isHemisphereLight){let E=i.hemi[g];E.direction.setFromMatrixPosition(S.matrixWorld),E.direction.transformDirection(d),g++}}}return{setup:a,setupView:l,state:i}}function sm(n){let e=new xM(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function yM(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new sm(n),e.set(s,[a])):r>=o.length?(a=new sm(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var vM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,SM=`uniform sampler2D shadow_pass;
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
}`,MM=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],bM=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],rm=new wt,wa=new G,tf=new G;function wM(n,e,t){let i=new Bs,s=new Ye,r=new Ye,o=new $t,a=new zl,l=new kl,c={},u=t.maxTextureSize,f={[Ws]:Un,[Un]:Ws,[gi]:gi},h=new Zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ye},radius:{value:4}},vertexShader:vM,fragmentShader:SM}),p=h.clone();p.defines.HORIZONTAL_PASS=1;let m=new pn;m.setAttribute("position",new Ln(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Et(m,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ga;let d=this.type;this.render=function(b,x,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||b.length===0)return;this.type===ep&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ga);let N=n.getRenderTarget(),A=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),D=n.state;D.setBlending(lr),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let F=d!==this.type;F&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(z=>z.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,z=b.length;I<z;I++){let X=b[I],B=X.shadow;if(B===void 0){Je("WebGLShadowMap:",X,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let he=B.getFrameExtents();s.multiply(he),r.copy(B.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/he.x),s.x=r.x*he.x,B.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/he.y),s.y=r.y*he.y,B.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(B.camera._reversedDepth=Y,B.map===null||F===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===lo){if(X.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new oi(s.x,s.y,{format:Xs,type:Pi,minFilter:Dn,magFilter:Dn,generateMipmaps:!1}),B.map.texture.name=X.name+".shadowMap",B.map.depthTexture=new ms(s.x,s.y,Ri),B.map.depthTexture.name=X.name+".shadowMapDepth",B.map.depthTexture.format=us,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Rn,B.map.depthTexture.magFilter=Rn}else X.isPointLight?(B.map=new Ta(s.x),B.map.depthTexture=new sa(s.x,Ci)):(B.map=new oi(s.x,s.y),B.map.depthTexture=new ms(s.x,s.y,Ci)),B.map.depthTexture.name=X.name+".shadowMap",B.map.depthTexture.format=us,this.type===ga?(B.map.depthTexture.compareFunction=Y?Vu:ku,B.map.depthTexture.minFilter=Dn,B.map.depthTexture.magFilter=Dn):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Rn,B.map.depthTexture.magFilter=Rn);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let ee=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();X.isPointLight!==!0&&B.updateMatrices(X,M);let re=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:M.layers;for(let Q=0;Q<ee;Q++){let ie=B.getCamera(Q);if(X.isPointLight){let Z=B.camera,de=B.matrix,se=X.distance||Z.far;se!==Z.far&&(Z.far=se,Z.updateProjectionMatrix()),wa.setFromMatrixPosition(X.matrixWorld),Z.position.copy(wa),tf.copy(Z.position),tf.add(MM[Q]),Z.up.copy(bM[Q]),Z.lookAt(tf),Z.updateMatrixWorld(),de.makeTranslation(-wa.x,-wa.y,-wa.z),rm.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),B._frustum.setFromProjectionMatrix(rm,Z.coordinateSystem,Z.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)n.setRenderTarget(B.map,Q),n.clear();else{Q===0&&(n.setRenderTarget(B.map),n.clear());let Z=B.getViewport(Q);o.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),D.viewport(o)}i=B.getFrustum(Q),S(x,M,ie,X,re,this.type)}B.isPointLightShadow!==!0&&this.type===lo&&y(B,M),B.needsUpdate=!1}d=this.type,g.needsUpdate=!1,n.setRenderTarget(N,A,C)};function y(b,x){let M=e.update(_);h.defines.VSM_SAMPLES!==b.blurSamples&&(h.defines.VSM_SAMPLES=b.blurSamples,p.defines.VSM_SAMPLES=b.blurSamples,h.needsUpdate=!0,p.needsUpdate=!0),b.mapPass===null?b.mapPass=new oi(s.x,s.y,{format:Xs,type:Pi}):(b.mapPass.width!==b.map.width||b.mapPass.height!==b.map.height)&&b.mapPass.setSize(b.map.width,b.map.height),h.uniforms.shadow_pass.value=b.map.depthTexture,h.uniforms.resolution.value.set(b.map.width,b.map.height),h.uniforms.radius.value=b.radius,n.setRenderTarget(b.mapPass),n.clear(),n.renderBufferDirect(x,null,M,h,_,null),p.uniforms.shadow_pass.value=b.mapPass.texture,p.uniforms.resolution.value.set(b.map.width,b.map.height),p.uniforms.radius.value=b.radius,n.setRenderTarget(b.map),n.clear(),n.renderBufferDirect(x,null,M,p,_,null)}function P(b,x,M,N){let A=null,C=M.isPointLight===!0?b.customDistanceMaterial:b.customDepthMaterial;if(C!==void 0)A=C;else if(A=M.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let D=A.uuid,F=x.uuid,I=c[D];I===void 0&&(I={},c[D]=I);let z=I[F];z===void 0&&(z=A.clone(),I[F]=z,x.addEventListener("dispose",E)),A=z}if(A.visible=x.visible,A.wireframe=x.wireframe,N===lo?A.side=x.shadowSide!==null?x.shadowSide:x.side:A.side=x.shadowSide!==null?x.shadowSide:f[x.side],A.alphaMap=x.alphaMap,A.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,A.map=x.map,A.clipShadows=x.clipShadows,A.clippingPlanes=x.clippingPlanes,A.clipIntersection=x.clipIntersection,A.displacementMap=x.displacementMap,A.displacementScale=x.displacementScale,A.displacementBias=x.displacementBias,A.wireframeLinewidth=x.wireframeLinewidth,A.linewidth=x.linewidth,M.isPointLight===!0&&A.isMeshDistanceMaterial===!0){let D=n.properties.get(A);D.light=M}return A}function S(b,x,M,N,A,C){if(b.visible===!1)return;if(b.layers.test(A)&&(b.isMesh||b.isLine||b.isPoints)&&(b.castShadow||b.receiveShadow&&C===lo)&&(!b.frustumCulled||b.intersectsFrustum(i))){b.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,b.matrixWorld);let I=e.update(b),z=b.material;if(Array.isArray(z)){let X=I.groups;for(let B=0,he=X.length;B<he;B++){let Y=X[B],ee=z[Y.materialIndex];if(ee&&ee.visible){let re=P(b,ee,N,C);b.onBeforeShadow(n,b,x,M,I,re,Y),n.renderBufferDirect(M,null,I,re,b,Y),b.onAfterShadow(n,b,x,M,I,re,Y)}}}else if(z.visible){let X=P(b,z,N,C);b.onBeforeShadow(n,b,x,M,I,X,null),n.renderBufferDirect(M,null,I,X,b,null),b.onAfterShadow(n,b,x,M,I,X,null)}}let F=b.children;for(let I=0,z=F.length;I<z;I++)S(F[I],x,M,N,A,C)}function E(b){b.target.removeEventListener("dispose",E);for(let M in c){let N=c[M],A=b.target.uuid;A in N&&(N[A].dispose(),delete N[A])}}}function EM(n,e){function t(){let k=!1,ue=new $t,ae=null,Ae=new $t(0,0,0,0);return{setMask:function(Se){ae!==Se&&!k&&(n.colorMask(Se,Se,Se,Se),ae=Se)},setLocked:function(Se){k=Se},setClear:function(Se,Ee,qe,et,_e){_e===!0&&(Se*=et,Ee*=et,qe*=et),ue.set(Se,Ee,qe,et),Ae.equals(ue)===!1&&(n.clearColor(Se,Ee,qe,et),Ae.copy(ue))},reset:function(){k=!1,ae=null,Ae.set(-1,0,0,0)}}}function i(){let k=!1,ue=!1,ae=null,Ae=null,Se=null;return{setReversed:function(Ee){if(ue!==Ee){let qe=e.get("EXT_clip_control");Ee?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),ue=Ee;let et=Se;Se=null,this.setClear(et)}},getReversed:function(){return ue},setTest:function(Ee){Ee?me(n.DEPTH_TEST):W(n.DEPTH_TEST)},setMask:function(Ee){ae!==Ee&&!k&&(n.depthMask(Ee),ae=Ee)},setFunc:function(Ee){if(ue&&(Ee=Dp[Ee]),Ae!==Ee){switch(Ee){case Sl:n.depthFunc(n.NEVER);break;case Ml:n.depthFunc(n.ALWAYS);break;case bl:n.depthFunc(n.LESS);break;case Jr:n.depthFunc(n.LEQUAL);break;case wl:n.depthFunc(n.EQUAL);break;case El:n.depthFunc(n.GEQUAL);break;case Tl:n.depthFunc(n.GREATER);break;case Al:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=Ee}},setLocked:function(Ee){k=Ee},setClear:function(Ee){Se!==Ee&&(Se=Ee,ue&&(Ee=1-Ee),n.clearDepth(Ee))},reset:function(){k=!1,ae=null,Ae=null,Se=null,ue=!1}}}function s(){let k=!1,ue=null,ae=null,Ae=null,Se=null,Ee=null,qe=null,et=null,_e=null;return{setTest:function(Ve){k||(Ve?me(n.STENCIL_TEST):W(n.STENCIL_TEST))},setMask:function(Ve){ue!==Ve&&!k&&(n.stencilMask(Ve),ue=Ve)},setFunc:function(Ve,tt,Pe){(ae!==Ve||Ae!==tt||Se!==Pe)&&(n.stencilFunc(Ve,tt,Pe),ae=Ve,Ae=tt,Se=Pe)},setOp:function(Ve,tt,Pe){(Ee!==Ve||qe!==tt||et!==Pe)&&(n.stencilOp(Ve,tt,Pe),Ee=Ve,qe=tt,et=Pe)},setLocked:function(Ve){k=Ve},setClear:function(Ve){_e!==Ve&&(n.clearStencil(Ve),_e=Ve)},reset:function(){k=!1,ue=null,ae=null,Ae=null,Se=null,Ee=null,qe=null,et=null,_e=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},p=new WeakMap,m=[],_=null,g=!1,d=null,y=null,P=null,S=null,E=null,b=null,x=null,M=new rt(0,0,0),N=0,A=!1,C=null,D=null,F=null,I=null,z=null,X=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,he=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(he=parseFloat(/^WebGL (\d)/.exec(Y)[1]),B=he>=1):Y.indexOf("OpenGL ES")!==-1&&(he=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),B=he>=2);let ee=null,re={},Q=n.getParameter(n.SCISSOR_BOX),ie=n.getParameter(n.VIEWPORT),Z=new $t().fromArray(Q),de=new $t().fromArray(ie);function se(k,ue,ae,Ae){let Se=new Uint8Array(4),Ee=n.createTexture();n.bindTexture(k,Ee),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let qe=0;qe<ae;qe++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(ue,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,Se):n.texImage2D(ue+qe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Se);return Ee}let ge={};ge[n.TEXTURE_2D]=se(n.TEXTURE_2D,n.TEXTURE_2D,1),ge[n.TEXTURE_CUBE_MAP]=se(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ge[n.TEXTURE_2D_ARRAY]=se(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ge[n.TEXTURE_3D]=se(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),me(n.DEPTH_TEST),o.setFunc(Jr),zt(!1),vt(yu),me(n.CULL_FACE),ht(lr);function me(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function W(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function ne(k,ue){return h[k]!==ue?(n.bindFramebuffer(k,ue),h[k]=ue,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=ue),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=ue),!0):!1}function le(k,ue){let ae=m,Ae=!1;if(k){ae=p.get(ue),ae===void 0&&(ae=[],p.set(ue,ae));let Se=k.textures;if(ae.length!==Se.length||ae[0]!==n.COLOR_ATTACHMENT0){for(let Ee=0,qe=Se.length;Ee<qe;Ee++)ae[Ee]=n.COLOR_ATTACHMENT0+Ee;ae.length=Se.length,Ae=!0}}else ae[0]!==n.BACK&&(ae[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(ae)}function De(k){return _!==k?(n.useProgram(k),_=k,!0):!1}let Oe={[cr]:n.FUNC_ADD,[np]:n.FUNC_SUBTRACT,[ip]:n.FUNC_REVERSE_SUBTRACT};Oe[sp]=n.MIN,Oe[rp]=n.MAX;let Xe={[op]:n.ZERO,[ap]:n.ONE,[lp]:n.SRC_COLOR,[bu]:n.SRC_ALPHA,[pp]:n.SRC_ALPHA_SATURATE,[fp]:n.DST_COLOR,[hp]:n.DST_ALPHA,[cp]:n.ONE_MINUS_SRC_COLOR,[wu]:n.ONE_MINUS_SRC_ALPHA,[dp]:n.ONE_MINUS_DST_COLOR,[up]:n.ONE_MINUS_DST_ALPHA,[mp]:n.CONSTANT_COLOR,[gp]:n.ONE_MINUS_CONSTANT_COLOR,[_p]:n.CONSTANT_ALPHA,[xp]:n.ONE_MINUS_CONSTANT_ALPHA};function ht(k,ue,ae,Ae,Se,Ee,qe,et,_e,Ve){if(k===lr){g===!0&&(W(n.BLEND),g=!1);return}if(g===!1&&(me(n.BLEND),g=!0),k!==tp){if(k!==d||Ve!==A){if((y!==cr||E!==cr)&&(n.blendEquation(n.FUNC_ADD),y=cr,E=cr),Ve)switch(k){case co:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case vu:n.blendFunc(n.ONE,n.ONE);break;case Su:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Mu:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qe("WebGLState: Invalid blending: ",k);break}else switch(k){case co:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case vu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Su:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Mu:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",k);break}P=null,S=null,b=null,x=null,M.set(0,0,0),N=0,d=k,A=Ve}return}Se=Se||ue,Ee=Ee||ae,qe=qe||Ae,(ue!==y||Se!==E)&&(n.blendEquationSeparate(Oe[ue],Oe[Se]),y=ue,E=Se),(ae!==P||Ae!==S||Ee!==b||qe!==x)&&(n.blendFuncSeparate(Xe[ae],Xe[Ae],Xe[Ee],Xe[qe]),P=ae,S=Ae,b=Ee,x=qe),(et.equals(M)===!1||_e!==N)&&(n.blendColor(et.r,et.g,et.b,_e),M.copy(et),N=_e),d=k,A=!1}function yt(k,ue){k.side===gi?W(n.CULL_FACE):me(n.CULL_FACE);let ae=k.side===Un;ue&&(ae=!ae),zt(ae),k.blending===co&&k.transparent===!1?ht(lr):ht(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ae=k.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),mt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?me(n.SAMPLE_ALPHA_TO_COVERAGE):W(n.SAMPLE_ALPHA_TO_COVERAGE)}function zt(k){C!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),C=k)}function vt(k){k!==jd?(me(n.CULL_FACE),k!==D&&(k===yu?n.cullFace(n.BACK):k===Qd?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):W(n.CULL_FACE),D=k}function Kt(k){k!==F&&(B&&n.lineWidth(k),F=k)}function mt(k,ue,ae){k?(me(n.POLYGON_OFFSET_FILL),(I!==ue||z!==ae)&&(I=ue,z=ae,o.getReversed()&&(ue=-ue,ae=-ae),n.polygonOffset(ue,ae))):W(n.POLYGON_OFFSET_FILL)}function sn(k){k?me(n.SCISSOR_TEST):W(n.SCISSOR_TEST)}function Nt(k){k===void 0&&(k=n.TEXTURE0+X-1),ee!==k&&(n.activeTexture(k),ee=k)}function jt(k,ue,ae){ae===void 0&&(ee===null?ae=n.TEXTURE0+X-1:ae=ee);let Ae=re[ae];Ae===void 0&&(Ae={type:void 0,texture:void 0},re[ae]=Ae),(Ae.type!==k||Ae.texture!==ue)&&(ee!==ae&&(n.activeTexture(ae),ee=ae),n.bindTexture(k,ue||ge[k]),Ae.type=k,Ae.texture=ue)}function V(){let k=re[ee];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Ie(){try{n.compressedTexImage2D(...arguments)}catch(k){Qe("WebGLState:",k)}}function Ke(){try{n.compressedTexImage3D(...arguments)}catch(k){Qe("WebGLState:",k)}}function ot(){try{n.texSubImage2D(...arguments)}catch(k){Qe("WebGLState:",k)}}function Te(){try{n.texSubImage3D(...arguments)}catch(k){Qe("WebGLState:",k)}}function Ut(){try{n.compressedTexSubImage2D(...arguments)}catch(k){Qe("WebGLState:",k)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(k){Qe("WebGLState:",k)}}function Ze(){try{n.texStorage2D(...arguments)}catch(k){Qe("WebGLState:",k)}}function L(){try{n.texStorage3D(...arguments)}catch(k){Qe("WebGLState:",k)}}function w(){try{n.texImage2D(...arguments)}catch(k){Qe("WebGLState:",k)}}function $(){try{n.texImage3D(...arguments)}catch(k){Qe("WebGLState:",k)}}function xe(k){return f[k]!==void 0?f[k]:n.getParameter(k)}function fe(k,ue){f[k]!==ue&&(n.pixelStorei(k,ue),f[k]=ue)}function Me(k){Z.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),Z.copy(k))}function be(k){de.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),de.copy(k))}function oe(k,ue){let ae=c.get(ue);ae===void 0&&(ae=new WeakMap,c.set(ue,ae));let Ae=ae.get(k);Ae===void 0&&(Ae=n.getUniformBlockIndex(ue,k.name),n.uniformBlockBinding(ue,Ae,Ae),ae.set(k,Ae))}function ce(k,ue,ae){let Se=c.get(ue).get(k);l[Se]!==ae&&(n.bindBufferBase(n.UNIFORM_BUFFER,Se,ae),l[Se]=ae)}function ve(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},ee=null,re={},h={},l={},p=new WeakMap,m=[],_=null,g=!1,d=null,y=null,P=null,S=null,E=null,b=null,x=null,M=new rt(0,0,0),N=0,A=!1,C=null,D=null,F=null,I=null,z=null,Z.set(0,0,n.canvas.width,n.canvas.height),de.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:me,disable:W,bindFramebuffer:ne,drawBuffers:le,useProgram:De,setBlending:ht,setMaterial:yt,setFlipSided:zt,setCullFace:vt,setLineWidth:Kt,setPolygonOffset:mt,setScissorTest:sn,activeTexture:Nt,bindTexture:jt,unbindTexture:V,compressedTexImage2D:Ie,compressedTexImage3D:Ke,texImage2D:w,texImage3D:$,pixelStorei:fe,getParameter:xe,updateUBOMapping:oe,uniformBlockBinding:ce,texStorage2D:Ze,texStorage3D:L,texSubImage2D:ot,texSubImage3D:Te,compressedTexSubImage2D:Ut,compressedTexSubImage3D:We,scissor:Me,viewport:be,reset:ve}}function TM(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ye,u=new WeakMap,f=new Set,h,p=new WeakMap,m=new Set,_=new FinalizationRegistry(L=>m.delete(L)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function d(L,w){return g?new OffscreenCanvas(L,w):$o("canvas")}function y(L,w,$){let xe=1,fe=Ze(L);if((fe.width>$||fe.height>$)&&(xe=$/Math.max(fe.width,fe.height)),xe<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let Me=Math.floor(xe*fe.width),be=Math.floor(xe*fe.height);h===void 0&&(h=d(Me,be));let oe=w?d(Me,be):h;return oe.width=Me,oe.height=be,oe.getContext("2d").drawImage(L,0,0,Me,be),Je("WebGLRenderer: Texture has been resized from ("+fe.width+"x"+fe.height+") to ("+Me+"x"+be+")."),oe}else return"data"in L&&Je("WebGLRenderer: Image in DataTexture is too big ("+fe.width+"x"+fe.height+")."),L;return L}function P(L){return L.generateMipmaps}function S(L){n.generateMipmap(L)}function E(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function b(L,w,$,xe,fe,Me=!1){if(L!==null){if(n[L]!==void 0)return n[L];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let be;xe&&(be=e.get("EXT_texture_norm16"),be||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let oe=w;if(w===n.RED&&($===n.FLOAT&&(oe=n.R32F),$===n.HALF_FLOAT&&(oe=n.R16F),$===n.UNSIGNED_BYTE&&(oe=n.R8),$===n.UNSIGNED_SHORT&&be&&(oe=be.R16_EXT),$===n.SHORT&&be&&(oe=be.R16_SNORM_EXT)),w===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(oe=n.R8UI),$===n.UNSIGNED_SHORT&&(oe=n.R16UI),$===n.UNSIGNED_INT&&(oe=n.R32UI),$===n.BYTE&&(oe=n.R8I),$===n.SHORT&&(oe=n.R16I),$===n.INT&&(oe=n.R32I)),w===n.RG&&($===n.FLOAT&&(oe=n.RG32F),$===n.HALF_FLOAT&&(oe=n.RG16F),$===n.UNSIGNED_BYTE&&(oe=n.RG8),$===n.UNSIGNED_SHORT&&be&&(oe=be.RG16_EXT),$===n.SHORT&&be&&(oe=be.RG16_SNORM_EXT)),w===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(oe=n.RG8UI),$===n.UNSIGNED_SHORT&&(oe=n.RG16UI),$===n.UNSIGNED_INT&&(oe=n.RG32UI),$===n.BYTE&&(oe=n.RG8I),$===n.SHORT&&(oe=n.RG16I),$===n.INT&&(oe=n.RG32I)),w===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(oe=n.RGB8UI),$===n.UNSIGNED_SHORT&&(oe=n.RGB16UI),$===n.UNSIGNED_INT&&(oe=n.RGB32UI),$===n.BYTE&&(oe=n.RGB8I),$===n.SHORT&&(oe=n.RGB16I),$===n.INT&&(oe=n.RGB32I)),w===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(oe=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(oe=n.RGBA16UI),$===n.UNSIGNED_INT&&(oe=n.RGBA32UI),$===n.BYTE&&(oe=n.RGBA8I),$===n.SHORT&&(oe=n.RGBA16I),$===n.INT&&(oe=n.RGBA32I)),w===n.RGB&&($===n.UNSIGNED_SHORT&&be&&(oe=be.RGB16_EXT),$===n.SHORT&&be&&(oe=be.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(oe=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(oe=n.R11F_G11F_B10F)),w===n.RGBA){let ce=Me?Yo:_t.getTransfer(fe);$===n.FLOAT&&(oe=n.RGBA32F),$===n.HALF_FLOAT&&(oe=n.RGBA16F),$===n.UNSIGNED_BYTE&&(oe=ce===Ct?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&be&&(oe=be.RGBA16_EXT),$===n.SHORT&&be&&(oe=be.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(oe=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(oe=n.RGB5_A1)}return(oe===n.R16F||oe===n.R32F||oe===n.RG16F||oe===n.RG32F||oe===n.RGBA16F||oe===n.RGBA32F)&&e.get("EXT_color_buffer_float"),oe}function x(L,w){let $;return L?w===null||w===Ci||w===ur?$=n.DEPTH24_STENCIL8:w===Ri?$=n.DEPTH32F_STENCIL8:w===uo&&($=n.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Ci||w===ur?$=n.DEPTH_COMPONENT24:w===Ri?$=n.DEPTH_COMPONENT32F:w===uo&&($=n.DEPTH_COMPONENT16),$}function M(L,w){return P(L)===!0||L.isFramebufferTexture&&L.minFilter!==Rn&&L.minFilter!==Dn?Math.log2(Math.max(w.width,w.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?w.mipmaps.length:1}function N(L){let w=new WeakRef(L);i.get(L).__ref=w,m.add(w),_.register(L,w,w)}function A(L){let w=i.get(L).__ref;w!==void 0&&(m.delete(w),_.unregister(w))}function C(L){F(L.target)}function D(L){I(L.target)}function F(L){L.removeEventListener("dispose",C),A(L),X(L),L.isVideoTexture&&u.delete(L),L.isHTMLTexture&&f.delete(L)}function I(L){L.removeEventListener("dispose",D),A(L),he(L)}function z(){for(let L of m){let w=L.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):F(w))}m.clear(),f.clear()}function X(L){let w=i.get(L);if(w.__webglInit===void 0)return;let $=L.source,xe=p.get($);if(xe){let fe=xe[w.__cacheKey];fe.usedTimes--,fe.usedTimes===0&&B(L),Object.keys(xe).length===0&&p.delete($)}i.remove(L)}function B(L){let w=i.get(L);n.deleteTexture(w.__webglTexture);let $=L.source,xe=p.get($);delete xe[w.__cacheKey],o.memory.textures--}function he(L){let w=i.get(L);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=L.depthTexture;if($&&$.renderTarget===L&&F($),L.isWebGLCubeRenderTarget)for(let fe=0;fe<6;fe++){if(Array.isArray(w.__webglFramebuffer[fe]))for(let Me=0;Me<w.__webglFramebuffer[fe].length;Me++)n.deleteFramebuffer(w.__webglFramebuffer[fe][Me]);else n.deleteFramebuffer(w.__webglFramebuffer[fe]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[fe])}else{if(Array.isArray(w.__webglFramebuffer))for(let fe=0;fe<w.__webglFramebuffer.length;fe++)n.deleteFramebuffer(w.__webglFramebuffer[fe]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let fe=0;fe<w.__webglColorRenderbuffer.length;fe++)w.__webglColorRenderbuffer[fe]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[fe]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let xe=L.textures;for(let fe=0,Me=xe.length;fe<Me;fe++){let be=i.get(xe[fe]);be.__webglTexture&&(n.deleteTexture(be.__webglTexture),o.memory.textures--),i.remove(xe[fe])}i.remove(L)}let Y=0;function ee(){Y=0}function re(){return Y}function Q(L){Y=L}function ie(){let L=Y;return L>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,L}function Z(L){let w=[];return w.push(L.wrapS),w.push(L.wrapT),w.push(L.wrapR||0),w.push(L.magFilter),w.push(L.minFilter),w.push(L.anisotropy),w.push(L.internalFormat),w.push(L.format),w.push(L.type),w.push(L.generateMipmaps),w.push(L.mipmapsAutoUpdate),w.push(L.premultiplyAlpha),w.push(L.flipY),w.push(L.unpackAlignment),w.push(L.colorSpace),w.join()}function de(L,w){let $=i.get(L);if(L.isVideoTexture&&Ut(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&$.__version!==L.version){let xe=L.image;if(xe===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(xe.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{yt($,L,w);return}}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+w)}function se(L,w){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){yt($,L,w);return}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+w)}function ge(L,w){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){yt($,L,w);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+w)}function me(L,w){let $=i.get(L);if(L.version>0&&$.__version!==L.version){zt($,L,w);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+w)}let W={[Cl]:n.REPEAT,[Xi]:n.CLAMP_TO_EDGE,[Rl]:n.MIRRORED_REPEAT},ne={[Rn]:n.NEAREST,[Sp]:n.NEAREST_MIPMAP_NEAREST,[_a]:n.NEAREST_MIPMAP_LINEAR,[Dn]:n.LINEAR,[nc]:n.LINEAR_MIPMAP_NEAREST,[_s]:n.LINEAR_MIPMAP_LINEAR},le={[Ep]:n.NEVER,[Gu]:n.ALWAYS,[Tp]:n.LESS,[ku]:n.LEQUAL,[Ap]:n.EQUAL,[Vu]:n.GEQUAL,[Cp]:n.GREATER,[Rp]:n.NOTEQUAL};function De(L,w){if(w.type===Ri&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Dn||w.magFilter===nc||w.magFilter===_a||w.magFilter===_s||w.minFilter===Dn||w.minFilter===nc||w.minFilter===_a||w.minFilter===_s)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,W[w.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,W[w.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,W[w.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,ne[w.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,ne[w.minFilter]),w.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,le[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Rn||w.minFilter!==_a&&w.minFilter!==_s||w.type===Ri&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(L,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function Oe(L,w){let $=!1;L.__webglInit===void 0&&(L.__webglInit=!0,w.addEventListener("dispose",C),N(w));let xe=w.source,fe=p.get(xe);fe===void 0&&(fe={},p.set(xe,fe));let Me=Z(w);if(Me!==L.__cacheKey){fe[Me]===void 0&&(fe[Me]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),fe[Me].usedTimes++;let be=fe[L.__cacheKey];be!==void 0&&(fe[L.__cacheKey].usedTimes--,be.usedTimes===0&&B(w)),L.__cacheKey=Me,L.__webglTexture=fe[Me].texture}return $}function Xe(L,w,$){return Math.floor(Math.floor(L/$)/w)}function ht(L,w,$,xe){let Me=L.updateRanges;if(Me.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,$,xe,w.data);else{Me.sort((k,ue)=>k.start-ue.start);let be=0;for(let k=1;k<Me.length;k++){let ue=Me[be],ae=Me[k],Ae=ue.start+ue.count,Se=Xe(ae.start,w.width,4),Ee=Xe(ue.start,w.width,4);ae.start<=Ae+1&&Se===Ee&&Xe(ae.start+ae.count-1,w.width,4)===Se?ue.count=Math.max(ue.count,ae.start+ae.count-ue.start):(++be,Me[be]=ae)}Me.length=be+1;let oe=t.getParameter(n.UNPACK_ROW_LENGTH),ce=t.getParameter(n.UNPACK_SKIP_PIXELS),ve=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let k=0,ue=Me.length;k<ue;k++){let ae=Me[k],Ae=Math.floor(ae.start/4),Se=Math.ceil(ae.count/4),Ee=Ae%w.width,qe=Math.floor(Ae/w.width),et=Se,_e=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Ee),t.pixelStorei(n.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(n.TEXTURE_2D,0,Ee,qe,et,_e,$,xe,w.data)}L.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,oe),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ce),t.pixelStorei(n.UNPACK_SKIP_ROWS,ve)}}function yt(L,w,$){let xe=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(xe=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(xe=n.TEXTURE_3D);let fe=Oe(L,w),Me=w.source;t.bindTexture(xe,L.__webglTexture,n.TEXTURE0+$);let be=i.get(Me);if(Me.version!==be.__version||fe===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let _e=_t.getPrimaries(_t.workingColorSpace),Ve=w.colorSpace===ys?null:_t.getPrimaries(w.colorSpace),tt=w.colorSpace===ys||_e===Ve?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let ce=y(w.image,!1,s.maxTextureSize);ce=We(w,ce);let ve=r.convert(w.format,w.colorSpace),k=r.convert(w.type),ue=b(w.internalFormat,ve,k,w.normalized,w.colorSpace,w.isVideoTexture);De(xe,w);let ae,Ae=w.mipmaps,Se=w.isVideoTexture!==!0,Ee=be.__version===void 0||fe===!0,qe=Me.dataReady,et=M(w,ce);if(w.isDepthTexture)ue=x(w.format===xs,w.type),Ee&&(Se?t.texStorage2D(n.TEXTURE_2D,1,ue,ce.width,ce.height):t.texImage2D(n.TEXTURE_2D,0,ue,ce.width,ce.height,0,ve,k,null));else if(w.isDataTexture)if(Ae.length>0){Se&&Ee&&t.texStorage2D(n.TEXTURE_2D,et,ue,Ae[0].width,Ae[0].height);for(let _e=0,Ve=Ae.length;_e<Ve;_e++)ae=Ae[_e],Se?qe&&t.texSubImage2D(n.TEXTURE_2D,_e,0,0,ae.width,ae.height,ve,k,ae.data):t.texImage2D(n.TEXTURE_2D,_e,ue,ae.width,ae.height,0,ve,k,ae.data);w.generateMipmaps=!1}else Se?(Ee&&t.texStorage2D(n.TEXTURE_2D,et,ue,ce.width,ce.height),qe&&ht(w,ce,ve,k)):t.texImage2D(n.TEXTURE_2D,0,ue,ce.width,ce.height,0,ve,k,ce.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){Se&&Ee&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,ue,Ae[0].width,Ae[0].height,ce.depth);for(let _e=0,Ve=Ae.length;_e<Ve;_e++)if(ae=Ae[_e],w.format!==Ii)if(ve!==null)if(Se){if(qe)if(w.layerUpdates.size>0){let tt=Qu(ae.width,ae.height,w.format,w.type);for(let Pe of w.layerUpdates){let at=ae.data.subarray(Pe*tt/ae.data.BYTES_PER_ELEMENT,(Pe+1)*tt/ae.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,_e,0,0,Pe,ae.width,ae.height,1,ve,at)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,_e,0,0,0,ae.width,ae.height,ce.depth,ve,ae.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,_e,ue,ae.width,ae.height,ce.depth,0,ae.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Se?qe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,_e,0,0,0,ae.width,ae.height,ce.depth,ve,k,ae.data):t.texImage3D(n.TEXTURE_2D_ARRAY,_e,ue,ae.width,ae.height,ce.depth,0,ve,k,ae.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{Se&&Ee&&t.texStorage2D(n.TEXTURE_2D,et,ue,Ae[0].width,Ae[0].height);for(let _e=0,Ve=Ae.length;_e<Ve;_e++)ae=Ae[_e],w.format!==Ii?ve!==null?Se?qe&&t.compressedTexSubImage2D(n.TEXTURE_2D,_e,0,0,ae.width,ae.height,ve,ae.data):t.compressedTexImage2D(n.TEXTURE_2D,_e,ue,ae.width,ae.height,0,ae.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Se?qe&&t.texSubImage2D(n.TEXTURE_2D,_e,0,0,ae.width,ae.height,ve,k,ae.data):t.texImage2D(n.TEXTURE_2D,_e,ue,ae.width,ae.height,0,ve,k,ae.data)}else if(w.isDataArrayTexture)if(Se){if(Ee&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,ue,ce.width,ce.height,ce.depth),qe)if(w.layerUpdates.size>0){let _e=Qu(ce.width,ce.height,w.format,w.type);for(let Ve of w.layerUpdates){let tt=ce.data.subarray(Ve*_e/ce.data.BYTES_PER_ELEMENT,(Ve+1)*_e/ce.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ve,ce.width,ce.height,1,ve,k,tt)}w.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ce.width,ce.height,ce.depth,ve,k,ce.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,ue,ce.width,ce.height,ce.depth,0,ve,k,ce.data);else if(w.isData3DTexture)Se?(Ee&&t.texStorage3D(n.TEXTURE_3D,et,ue,ce.width,ce.height,ce.depth),qe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ce.width,ce.height,ce.depth,ve,k,ce.data)):t.texImage3D(n.TEXTURE_3D,0,ue,ce.width,ce.height,ce.depth,0,ve,k,ce.data);else if(w.isFramebufferTexture){if(Ee)if(Se)t.texStorage2D(n.TEXTURE_2D,et,ue,ce.width,ce.height);else{let _e=ce.width,Ve=ce.height;for(let tt=0;tt<et;tt++)t.texImage2D(n.TEXTURE_2D,tt,ue,_e,Ve,0,ve,k,null),_e>>=1,Ve>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let _e=n.canvas;if(_e.hasAttribute("layoutsubtree")||_e.setAttribute("layoutsubtree","true"),ce.parentNode!==_e){_e.appendChild(ce),f.add(w),_e.onpaint=Ve=>{let tt=Ve.changedElements;for(let Pe of f)tt.includes(Pe.image)&&(Pe.needsUpdate=!0)},_e.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ce);else{let tt=n.RGBA,Pe=n.RGBA,at=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,tt,Pe,at,ce)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(Se&&Ee){let _e=Ze(Ae[0]);t.texStorage2D(n.TEXTURE_2D,et,ue,_e.width,_e.height)}for(let _e=0,Ve=Ae.length;_e<Ve;_e++)ae=Ae[_e],Se?qe&&t.texSubImage2D(n.TEXTURE_2D,_e,0,0,ve,k,ae):t.texImage2D(n.TEXTURE_2D,_e,ue,ve,k,ae);w.generateMipmaps=!1}else if(Se){if(Ee){let _e=Ze(ce);t.texStorage2D(n.TEXTURE_2D,et,ue,_e.width,_e.height)}qe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ve,k,ce)}else t.texImage2D(n.TEXTURE_2D,0,ue,ve,k,ce);P(w)&&w.mipmapsAutoUpdate===!0&&S(xe),be.__version=Me.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function zt(L,w,$){if(w.image.length!==6)return;let xe=Oe(L,w),fe=w.source;t.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+$);let Me=i.get(fe);if(fe.version!==Me.__version||xe===!0){t.activeTexture(n.TEXTURE0+$);let be=_t.getPrimaries(_t.workingColorSpace),oe=w.colorSpace===ys?null:_t.getPrimaries(w.colorSpace),ce=w.colorSpace===ys||be===oe?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ce);let ve=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,ue=[];for(let Pe=0;Pe<6;Pe++)!ve&&!k?ue[Pe]=y(w.image[Pe],!0,s.maxCubemapSize):ue[Pe]=k?w.image[Pe].image:w.image[Pe],ue[Pe]=We(w,ue[Pe]);let ae=ue[0],Ae=r.convert(w.format,w.colorSpace),Se=r.convert(w.type),Ee=b(w.internalFormat,Ae,Se,w.normalized,w.colorSpace),qe=w.isVideoTexture!==!0,et=Me.__version===void 0||xe===!0,_e=fe.dataReady,Ve=M(w,ae);De(n.TEXTURE_CUBE_MAP,w);let tt;if(w.isDepthTexture){if(Ee=x(w.format===xs,w.type),et)if(qe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Ee,ae.width,ae.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,ae.width,ae.height,0,Ae,Se,null)}else if(ve){qe&&et&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,Ee,ae.width,ae.height);for(let Pe=0;Pe<6;Pe++){tt=ue[Pe].mipmaps;for(let at=0;at<tt.length;at++){let kt=tt[at];w.format!==Ii?Ae!==null?qe?_e&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,at,0,0,kt.width,kt.height,Ae,kt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,at,Ee,kt.width,kt.height,0,kt.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?_e&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,at,0,0,kt.width,kt.height,Ae,Se,kt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,at,Ee,kt.width,kt.height,0,Ae,Se,kt.data)}}}else{if(tt=w.mipmaps,qe&&et){tt.length>0&&Ve++;let Pe=Ze(ue[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,Ee,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(k){qe?_e&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,ue[Pe].width,ue[Pe].height,Ae,Se,ue[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,ue[Pe].width,ue[Pe].height,0,Ae,Se,ue[Pe].data);for(let at=0;at<tt.length;at++){let Gn=tt[at].image[Pe].image;qe?_e&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,at+1,0,0,Gn.width,Gn.height,Ae,Se,Gn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,at+1,Ee,Gn.width,Gn.height,0,Ae,Se,Gn.data)}}else{qe?_e&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Ae,Se,ue[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,Ae,Se,ue[Pe]);for(let at=0;at<tt.length;at++){let kt=tt[at];qe?_e&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,at+1,0,0,Ae,Se,kt.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,at+1,Ee,Ae,Se,kt.image[Pe])}}}P(w)&&w.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),Me.__version=fe.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function vt(L,w,$,xe,fe,Me){let be=r.convert($.format,$.colorSpace),oe=r.convert($.type),ce=b($.internalFormat,be,oe,$.normalized,$.colorSpace),ve=i.get(w),k=i.get($);if(k.__renderTarget=w,!ve.__hasExternalTextures){let ue=Math.max(1,w.width>>Me),ae=Math.max(1,w.height>>Me);fe===n.TEXTURE_3D||fe===n.TEXTURE_2D_ARRAY?t.texImage3D(fe,Me,ce,ue,ae,w.depth,0,be,oe,null):t.texImage2D(fe,Me,ce,ue,ae,0,be,oe,null)}t.bindFramebuffer(n.FRAMEBUFFER,L),Te(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xe,fe,k.__webglTexture,0,ot(w)):(fe===n.TEXTURE_2D||fe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&fe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,xe,fe,k.__webglTexture,Me),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Kt(L,w,$){if(n.bindRenderbuffer(n.RENDERBUFFER,L),w.depthBuffer){let xe=w.depthTexture,fe=xe&&xe.isDepthTexture?xe.type:null,Me=x(w.stencilBuffer,fe),be=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Te(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(w),Me,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(w),Me,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,Me,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,be,n.RENDERBUFFER,L)}else{let xe=w.textures;for(let fe=0;fe<xe.length;fe++){let Me=xe[fe],be=r.convert(Me.format,Me.colorSpace),oe=r.convert(Me.type),ce=b(Me.internalFormat,be,oe,Me.normalized,Me.colorSpace);Te(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(w),ce,w.width,w.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(w),ce,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,ce,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function mt(L,w,$){let xe=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,L),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let fe=i.get(w.depthTexture);fe.__renderTarget=w;let Me=xe?w.depthTexture.image[0]:w.depthTexture.image;(!fe.__webglTexture||Me.width!==w.width||Me.height!==w.height)&&(Me.width=w.width,Me.height=w.height,w.depthTexture.needsUpdate=!0),xe?me(w.depthTexture,0):de(w.depthTexture,0);let be=fe.__webglTexture,oe=ot(w),ce=xe?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,ve=w.depthTexture.format===xs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===us)Te(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ve,ce,be,0,oe):n.framebufferTexture2D(n.FRAMEBUFFER,ve,ce,be,0);else if(w.depthTexture.format===xs)Te(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ve,ce,be,0,oe):n.framebufferTexture2D(n.FRAMEBUFFER,ve,ce,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function sn(L){let w=i.get(L),$=L.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==L.depthTexture){let xe=L.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),xe){let fe=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,xe.removeEventListener("dispose",fe)};xe.addEventListener("dispose",fe),w.__depthDisposeCallback=fe}w.__boundDepthTexture=xe}if(L.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let xe=0;xe<6;xe++)mt(w.__webglFramebuffer[xe],L,xe);else L.texture.mipmaps.length>0?mt(w.__webglFramebuffer[0],L,0):mt(w.__webglFramebuffer,L,0);else if($){w.__webglDepthbuffer=[];for(let xe=0;xe<6;xe++)if(t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[xe]),w.__webglDepthbuffer[xe]===void 0)w.__webglDepthbuffer[xe]=n.createRenderbuffer(),Kt(w.__webglDepthbuffer[xe],L,!1);else{let fe=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Me=w.__webglDepthbuffer[xe];n.bindRenderbuffer(n.RENDERBUFFER,Me),n.framebufferRenderbuffer(n.FRAMEBUFFER,fe,n.RENDERBUFFER,Me)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),Kt(w.__webglDepthbuffer,L,!1);else{let fe=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Me=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,Me),n.framebufferRenderbuffer(n.FRAMEBUFFER,fe,n.RENDERBUFFER,Me)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Nt(L,w,$){let xe=i.get(L);w!==void 0&&vt(xe.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&sn(L)}function jt(L){let w=L.texture,$=i.get(L),xe=i.get(w);L.addEventListener("dispose",D),N(L);let fe=L.textures,Me=L.isWebGLCubeRenderTarget===!0,be=fe.length>1;if(be||(xe.__webglTexture===void 0&&(xe.__webglTexture=n.createTexture()),xe.__version=w.version,o.memory.textures++),Me){$.__webglFramebuffer=[];for(let oe=0;oe<6;oe++)if(w.mipmaps.length>0){$.__webglFramebuffer[oe]=[];for(let ce=0;ce<w.mipmaps.length;ce++)$.__webglFramebuffer[oe][ce]=n.createFramebuffer()}else $.__webglFramebuffer[oe]=n.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let oe=0;oe<w.mipmaps.length;oe++)$.__webglFramebuffer[oe]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(be)for(let oe=0,ce=fe.length;oe<ce;oe++){let ve=i.get(fe[oe]);ve.__webglTexture===void 0&&(ve.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&Te(L)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let oe=0;oe<fe.length;oe++){let ce=fe[oe];$.__webglColorRenderbuffer[oe]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[oe]);let ve=r.convert(ce.format,ce.colorSpace),k=r.convert(ce.type),ue=b(ce.internalFormat,ve,k,ce.normalized,ce.colorSpace,L.isXRRenderTarget===!0),ae=ot(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,ae,ue,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.RENDERBUFFER,$.__webglColorRenderbuffer[oe])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Kt($.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(Me){t.bindTexture(n.TEXTURE_CUBE_MAP,xe.__webglTexture),De(n.TEXTURE_CUBE_MAP,w);for(let oe=0;oe<6;oe++)if(w.mipmaps.length>0)for(let ce=0;ce<w.mipmaps.length;ce++)vt($.__webglFramebuffer[oe][ce],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,ce);else vt($.__webglFramebuffer[oe],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0);P(w)?S(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(be){for(let oe=0,ce=fe.length;oe<ce;oe++){let ve=fe[oe],k=i.get(ve),ue=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ue=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ue,k.__webglTexture),De(ue,ve),vt($.__webglFramebuffer,L,ve,n.COLOR_ATTACHMENT0+oe,ue,0),P(ve)&&S(ue)}t.unbindTexture()}else{let oe=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(oe=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,xe.__webglTexture),De(oe,w),w.mipmaps.length>0)for(let ce=0;ce<w.mipmaps.length;ce++)vt($.__webglFramebuffer[ce],L,w,n.COLOR_ATTACHMENT0,oe,ce);else vt($.__webglFramebuffer,L,w,n.COLOR_ATTACHMENT0,oe,0);P(w)?S(oe):w.mipmaps.length>0&&n.texParameteri(oe,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&sn(L)}function V(L){let w=L.textures;for(let $=0,xe=w.length;$<xe;$++){let fe=w[$];if(P(fe)&&fe.mipmapsAutoUpdate===!0){let Me=E(L),be=i.get(fe).__webglTexture;t.bindTexture(Me,be),S(Me),t.unbindTexture()}}}let Ie=[];function Ke(L){if(L.samples>0){if(Te(L)===!1){let w=L.textures,$=L.width,xe=L.height,fe=n.COLOR_BUFFER_BIT,Me=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=i.get(L),oe=w.length>1;if(oe)for(let ve=0;ve<w.length;ve++)t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ve,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ve,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let ve=0;ve<w.length;ve++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(fe|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(fe|=n.STENCIL_BUFFER_BIT)),oe){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,be.__webglColorRenderbuffer[ve]);let k=i.get(w[ve]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,$,xe,0,0,$,xe,fe,n.NEAREST),l===!0&&(Ie.length=0,Ie.push(n.COLOR_ATTACHMENT0+ve),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Ie.push(Me),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),oe)for(let ve=0;ve<w.length;ve++){t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ve,n.RENDERBUFFER,be.__webglColorRenderbuffer[ve]);let k=i.get(w[ve]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ve,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let w=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function ot(L){return Math.min(s.maxSamples,L.samples)}function Te(L){let w=i.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Ut(L){let w=o.render.frame;u.get(L)!==w&&(u.set(L,w),L.update())}function We(L,w){let $=L.colorSpace,xe=L.format,fe=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||$!==qo&&$!==ys&&(_t.getTransfer($)===Ct?(xe!==Ii||fe!==jn)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",$)),w}function Ze(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=ie,this.resetTextureUnits=ee,this.getTextureUnits=re,this.setTextureUnits=Q,this.setTexture2D=de,this.setTexture2DArray=se,this.setTexture3D=ge,this.setTextureCube=me,this.rebindTextures=Nt,this.setupRenderTarget=jt,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=sn,this.setupFrameBufferTexture=vt,this.useMultisampledRTT=Te,this.dispose=z}function AM(n,e){function t(i,s=ys){let r,o=_t.getTransfer(s);if(i===jn)return n.UNSIGNED_BYTE;if(i===sc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===rc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Uu)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Fu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Du)return n.BYTE;if(i===Nu)return n.SHORT;if(i===uo)return n.UNSIGNED_SHORT;if(i===ic)return n.INT;if(i===Ci)return n.UNSIGNED_INT;if(i===Ri)return n.FLOAT;if(i===Pi)return n.HALF_FLOAT;if(i===Ou)return n.ALPHA;if(i===Bu)return n.RGB;if(i===Ii)return n.RGBA;if(i===us)return n.DEPTH_COMPONENT;if(i===xs)return n.DEPTH_STENCIL;if(i===zu)return n.RED;if(i===oc)return n.RED_INTEGER;if(i===Xs)return n.RG;if(i===ac)return n.RG_INTEGER;if(i===lc)return n.RGBA_INTEGER;if(i===xa||i===ya||i===va||i===Sa)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===xa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Sa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===xa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ya)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Sa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===cc||i===hc||i===uc||i===fc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===cc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===hc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===uc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===fc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===dc||i===pc||i===mc||i===gc||i===_c||i===Ma||i===xc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===dc||i===pc)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===mc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===gc)return r.COMPRESSED_R11_EAC;if(i===_c)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ma)return r.COMPRESSED_RG11_EAC;if(i===xc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===yc||i===vc||i===Sc||i===Mc||i===bc||i===wc||i===Ec||i===Tc||i===Ac||i===Cc||i===Rc||i===Pc||i===Ic||i===Lc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===yc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===vc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Sc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Mc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===bc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===wc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ec)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Tc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ac)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Cc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Rc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Pc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Ic)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Lc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Dc||i===Nc||i===Uc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Dc)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Nc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Uc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Fc||i===Oc||i===ba||i===Bc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Fc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Oc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ba)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Bc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ur?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var CM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,RM=`
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

}`,cf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ra(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Zi({vertexShader:CM,fragmentShader:RM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Et(new aa(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},hf=class extends Ti{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,p=null,m=null,_=typeof XRWebGLBinding<"u",g=new cf,d={},y=t.getContextAttributes(),P=null,S=null,E=[],b=[],x=new Ye,M=null,N=null,A=new $n;A.viewport=new $t;let C=new $n;C.viewport=new $t;let D=[A,C],F=new jl,I=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let de=E[Z];return de===void 0&&(de=new no,E[Z]=de),de.getTargetRaySpace()},this.getControllerGrip=function(Z){let de=E[Z];return de===void 0&&(de=new no,E[Z]=de),de.getGripSpace()},this.getHand=function(Z){let de=E[Z];return de===void 0&&(de=new no,E[Z]=de),de.getHandSpace()};function X(Z){let de=b.indexOf(Z.inputSource);if(de===-1)return;let se=E[de];se!==void 0&&(se.update(Z.inputSource,Z.frame,c||o),se.dispatchEvent({type:Z.type,data:Z.inputSource}))}function B(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",he);for(let Z=0;Z<E.length;Z++){let de=b[Z];de!==null&&(b[Z]=null,E[Z].disconnect(de))}I=null,z=null,g.reset();for(let Z in d)delete d[Z];if(e.setRenderTarget(P),p=null,h=null,f=null,s=null,S=null,ie.stop(),i.isPresenting=!1,e.setPixelRatio(M),e.setSize(x.width,x.height,!1),N!==null){let Z=N.camera;Z.fov=N.fov,Z.zoom=N.zoom,Z.updateProjectionMatrix(),N=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){a=Z,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return h!==null?h:p},this.getBinding=function(){return f===null&&_&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(P=e.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",B),s.addEventListener("inputsourceschange",he),y.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let se=null,ge=null,me=null;y.depth&&(me=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,se=y.stencil?xs:us,ge=y.stencil?ur:Ci);let W={colorFormat:t.RGBA8,depthFormat:me,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(W),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new oi(h.textureWidth,h.textureHeight,{format:Ii,type:jn,depthTexture:new ms(h.textureWidth,h.textureHeight,ge,void 0,void 0,void 0,void 0,void 0,void 0,se),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let se={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,se),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new oi(p.framebufferWidth,p.framebufferHeight,{format:Ii,type:jn,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ie.setContext(s),ie.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function he(Z){for(let de=0;de<Z.removed.length;de++){let se=Z.removed[de],ge=b.indexOf(se);ge>=0&&(b[ge]=null,E[ge].disconnect(se))}for(let de=0;de<Z.added.length;de++){let se=Z.added[de],ge=b.indexOf(se);if(ge===-1){for(let W=0;W<E.length;W++)if(W>=b.length){b.push(se),ge=W;break}else if(b[W]===null){b[W]=se,ge=W;break}if(ge===-1)break}let me=E[ge];me&&me.connect(se)}}function Y(Z,de){de===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(de.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let de=Z.near,se=Z.far;g.texture!==null&&(g.depthNear>0&&(de=g.depthNear),g.depthFar>0&&(se=g.depthFar)),F.near=C.near=A.near=de,F.far=C.far=A.far=se,(I!==F.near||z!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),I=F.near,z=F.far),F.layers.mask=Z.layers.mask|6,A.layers.mask=F.layers.mask&-5,C.layers.mask=F.layers.mask&-3;let ge=Z.parent,me=F.cameras;Y(F,ge);for(let W=0;W<me.length;W++)Y(me[W],ge);F.projectionMatrix.copy(A.projectionMatrix),F.projectionMatrixInverse.copy(A.projectionMatrixInverse),N===null&&Z.isPerspectiveCamera&&(N={camera:Z,fov:Z.fov,zoom:Z.zoom}),ee(Z,F,ge)};function ee(Z,de,se){se===null?Z.matrix.copy(de.matrixWorld):(Z.matrix.copy(se.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(de.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(de.projectionMatrix),Z.projectionMatrixInverse.copy(de.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=Qr*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(h===null&&p===null))return l},this.setFoveation=function(Z){l=Z,h!==null&&(h.fixedFoveation=Z),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Z)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(F)},this.getCameraTexture=function(Z){return d[Z]};let re=null;function Q(Z,de){if(u=de.getViewerPose(c||o),m=de,u!==null){let se=u.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let ge=!1;se.length!==F.cameras.length&&(F.cameras.length=0,ge=!0);for(let le=0;le<se.length;le++){let De=se[le],Oe=null;if(p!==null)Oe=p.getViewport(De);else{let ht=f.getViewSubImage(h,De);Oe=ht.viewport,le===0&&(e.setRenderTargetTextures(S,ht.colorTexture,ht.depthStencilTexture),e.setRenderTarget(S))}let Xe=D[le];Xe===void 0&&(Xe=new $n,Xe.layers.enable(le),Xe.viewport=new $t,D[le]=Xe),Xe.matrix.fromArray(De.transform.matrix),Xe.matrix.decompose(Xe.position,Xe.quaternion,Xe.scale),Xe.projectionMatrix.fromArray(De.projectionMatrix),Xe.projectionMatrixInverse.copy(Xe.projectionMatrix).invert(),Xe.viewport.set(Oe.x,Oe.y,Oe.width,Oe.height),le===0&&(F.matrix.copy(Xe.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),ge===!0&&F.cameras.push(Xe)}let me=s.enabledFeatures;if(me&&me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){f=i.getBinding();let le=f.getDepthInformation(se[0]);le&&le.isValid&&le.texture&&g.init(le,s.renderState)}if(me&&me.includes("camera-access")&&_){e.state.unbindTexture(),f=i.getBinding();for(let le=0;le<se.length;le++){let De=se[le].camera;if(De){let Oe=d[De];Oe||(Oe=new ra,d[De]=Oe);let Xe=f.getCameraImage(De);Oe.sourceTexture=Xe}}}}for(let se=0;se<E.length;se++){let ge=b[se],me=E[se];ge!==null&&me!==void 0&&me.update(ge,de,c||o)}re&&re(Z,de),de.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:de}),m=null}let ie=new om;ie.setAnimationLoop(Q),this.setAnimationLoop=function(Z){re=Z},this.dispose=function(){}}},PM=new wt,gm=new it;gm.set(-1,0,0,0,1,0,0,0,1);function IM(n,e){function t(g,d){g.matrixAutoUpdate===!0&&g.updateMatrix(),d.value.copy(g.matrix)}function i(g,d){d.color.getRGB(g.fogColor.value,Ju(n)),d.isFog?(g.fogNear.value=d.near,g.fogFar.value=d.far):d.isFogExp2&&(g.fogDensity.value=d.density)}function s(g,d,y,P,S){d.isNodeMaterial?d.uniformsNeedUpdate=!1:d.isMeshBasicMaterial?r(g,d):d.isMeshLambertMaterial?(r(g,d),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)):d.isMeshToonMaterial?(r(g,d),f(g,d)):d.isMeshPhongMaterial?(r(g,d),u(g,d),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)):d.isMeshStandardMaterial?(r(g,d),h(g,d),d.isMeshPhysicalMaterial&&p(g,d,S)):d.isMeshMatcapMaterial?(r(g,d),m(g,d)):d.isMeshDepthMaterial?r(g,d):d.isMeshDistanceMaterial?(r(g,d),_(g,d)):d.isMeshNormalMaterial?r(g,d):d.isLineBasicMaterial?(o(g,d),d.isLineDashedMaterial&&a(g,d)):d.isPointsMaterial?l(g,d,y,P):d.isSpriteMaterial?c(g,d):d.isShadowMaterial?(g.color.value.copy(d.color),g.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(g,d){g.opacity.value=d.opacity,d.color&&g.diffuse.value.copy(d.color),d.emissive&&g.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(g.map.value=d.map,t(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,t(d.alphaMap,g.alphaMapTransform)),d.bumpMap&&(g.bumpMap.value=d.bumpMap,t(d.bumpMap,g.bumpMapTransform),g.bumpScale.value=d.bumpScale,d.side===Un&&(g.bumpScale.value*=-1)),d.normalMap&&(g.normalMap.value=d.normalMap,t(d.normalMap,g.normalMapTransform),g.normalScale.value.copy(d.normalScale),d.side===Un&&g.normalScale.value.negate()),d.displacementMap&&(g.displacementMap.value=d.displacementMap,t(d.displacementMap,g.displacementMapTransform),g.displacementScale.value=d.displacementScale,g.displacementBias.value=d.displacementBias),d.emissiveMap&&(g.emissiveMap.value=d.emissiveMap,t(d.emissiveMap,g.emissiveMapTransform)),d.specularMap&&(g.specularMap.value=d.specularMap,t(d.specularMap,g.specularMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest);let y=e.get(d),P=y.envMap,S=y.envMapRotation;P&&(g.envMap.value=P,g.envMapRotation.value.setFromMatrix4(PM.makeRotationFromEuler(S)).transpose(),P.isCubeTexture&&P.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(gm),g.reflectivity.value=d.reflectivity,g.ior.value=d.ior,g.refractionRatio.value=d.refractionRatio),d.lightMap&&(g.lightMap.value=d.lightMap,g.lightMapIntensity.value=d.lightMapIntensity,t(d.lightMap,g.lightMapTransform)),d.aoMap&&(g.aoMap.value=d.aoMap,g.aoMapIntensity.value=d.aoMapIntensity,t(d.aoMap,g.aoMapTransform))}function o(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,d.map&&(g.map.value=d.map,t(d.map,g.mapTransform))}function a(g,d){g.dashSize.value=d.dashSize,g.totalSize.value=d.dashSize+d.gapSize,g.scale.value=d.scale}function l(g,d,y,P){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.size.value=d.size*y,g.scale.value=P*.5,d.map&&(g.map.value=d.map,t(d.map,g.uvTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,t(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function c(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.rotation.value=d.rotation,d.map&&(g.map.value=d.map,t(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,t(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function u(g,d){g.specular.value.copy(d.specular),g.shininess.value=Math.max(d.shininess,1e-4)}function f(g,d){d.gradientMap&&(g.gradientMap.value=d.gradientMap)}function h(g,d){g.metalness.value=d.metalness,d.metalnessMap&&(g.metalnessMap.value=d.metalnessMap,t(d.metalnessMap,g.metalnessMapTransform)),g.roughness.value=d.roughness,d.roughnessMap&&(g.roughnessMap.value=d.roughnessMap,t(d.roughnessMap,g.roughnessMapTransform)),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)}function p(g,d,y){g.ior.value=d.ior,d.diffuseRoughness>0&&(g.diffuseRoughness.value=d.diffuseRoughness,d.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=d.diffuseRoughnessMap,t(d.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),d.sheen>0&&(g.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),g.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(g.sheenColorMap.value=d.sheenColorMap,t(d.sheenColorMap,g.sheenColorMapTransform)),d.sheenRoughnessMap&&(g.sheenRoughnessMap.value=d.sheenRoughnessMap,t(d.sheenRoughnessMap,g.sheenRoughnessMapTransform))),d.clearcoat>0&&(g.clearcoat.value=d.clearcoat,g.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(g.clearcoatMap.value=d.clearcoatMap,t(d.clearcoatMap,g.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,t(d.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(g.clearcoatNormalMap.value=d.clearcoatNormalMap,t(d.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Un&&g.clearcoatNormalScale.value.negate())),d.dispersion>0&&(g.dispersion.value=d.dispersion),d.retroreflectivity>0&&(g.retroreflectivity.value=d.retroreflectivity),d.iridescence>0&&(g.iridescence.value=d.iridescence,g.iridescenceIOR.value=d.iridescenceIOR,g.iridescenceThicknessMinimum.value=d.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=d.iridescenceThicknessMaximum,d.iridescenceMap&&(g.iridescenceMap.value=d.iridescenceMap,t(d.iridescenceMap,g.iridescenceMapTransform)),d.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=d.iridescenceThicknessMap,t(d.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),d.transmission>0&&(g.transmission.value=d.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),d.transmissionMap&&(g.transmissionMap.value=d.transmissionMap,t(d.transmissionMap,g.transmissionMapTransform)),g.thickness.value=d.thickness,d.thicknessMap&&(g.thicknessMap.value=d.thicknessMap,t(d.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=d.attenuationDistance,g.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(g.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(g.anisotropyMap.value=d.anisotropyMap,t(d.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=d.specularIntensity,g.specularColor.value.copy(d.specularColor),d.specularColorMap&&(g.specularColorMap.value=d.specularColorMap,t(d.specularColorMap,g.specularColorMapTransform)),d.specularIntensityMap&&(g.specularIntensityMap.value=d.specularIntensityMap,t(d.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,d){d.matcap&&(g.matcap.value=d.matcap)}function _(g,d){let y=e.get(d).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function LM(n,e,t,i){let s={},r={};function o(y,P){let S=P.program;i.uniformBlockBinding(y,S,s[y.id])}function a(y,P){let S=s[y.id];S===void 0&&(m(y),S=l(y),s[y.id]=S,y.addEventListener("dispose",g));let E=P.program;i.updateUBOMapping(y,E);let b=e.render.frame;r[y.id]!==b&&(c(y),r[y.id]=b)}function l(y){let P=n.createBuffer(),S=y.__size,E=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,P),n.bufferData(n.UNIFORM_BUFFER,S,E),n.bindBuffer(n.UNIFORM_BUFFER,null),P}function c(y){let P=s[y.id],S=y.uniforms,E=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,P);for(let b=0,x=S.length;b<x;b++){let M=S[b];if(Array.isArray(M))for(let N=0,A=M.length;N<A;N++)u(M[N],b,N,E);else u(M,b,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,P,S,E){if(h(y,P,S,E)===!0){let b=y.__offset,x=y.value;if(Array.isArray(x)){let M=0;for(let N=0;N<x.length;N++){let A=x[N],C=_(A,!0);f(A,y.__data,M),M+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,b,y.__data)}}function f(y,P,S){typeof y=="number"||typeof y=="boolean"?P[S]=y:y.isMatrix3?(P[S]=y.elements[0],P[S+1]=y.elements[1],P[S+2]=y.elements[2],P[S+3]=0,P[S+4]=y.elements[3],P[S+5]=y.elements[4],P[S+6]=y.elements[5],P[S+7]=0,P[S+8]=y.elements[6],P[S+9]=y.elements[7],P[S+10]=y.elements[8],P[S+11]=0):ArrayBuffer.isView(y)?P.set(y.subarray(0,P.length-S),S):y.toArray(P,S)}function h(y,P,S,E){let b=y.value,x=P+"_"+S;if(Array.isArray(b)){E[x]===void 0&&(E[x]=[]);let M=E[x],N=!1;for(let A=0;A<b.length;A++)p(b[A],M,A)===!0&&(N=!0);return N}return p(b,E,x)}function p(y,P,S){if(P[S]===void 0)return typeof y=="number"||typeof y=="boolean"?P[S]=y:ArrayBuffer.isView(y)?P[S]=y.slice():P[S]=y.clone(),!0;{let E=P[S];if(typeof y=="number"||typeof y=="boolean"){if(E!==y)return P[S]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(E.equals(y)===!1)return E.copy(y),!0}}return!1}function m(y){let P=y.uniforms,S=0,E=16;for(let x=0,M=P.length;x<M;x++){let N=Array.isArray(P[x])?P[x]:[P[x]];for(let A=0,C=N.length;A<C;A++){let D=N[A],F=Array.isArray(D.value)?D.value:[D.value],I=Array.isArray(P[x])||Array.isArray(D.value),z=S;for(let B=0,he=F.length;B<he;B++){let Y=F[B],ee=_(Y,I),re=S%E,Q=re%ee.boundary,ie=re+Q;S+=Q,ie!==0&&E-ie<ee.storage&&(S+=E-ie),B===0&&(z=S),S+=ee.storage}let X=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new X((S-z)/Float32Array.BYTES_PER_ELEMENT),D.__offset=z}}let b=S%E;return b>0&&(S+=E-b),y.__size=S,y.__cache={},this}function _(y,P){let S={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(S.boundary=4,S.storage=4):y.isVector2?(S.boundary=8,S.storage=8):y.isVector3||y.isColor?(S.boundary=16,S.storage=12):y.isVector4?(S.boundary=16,S.storage=16):y.isMatrix3?(S.boundary=16,S.storage=48):y.isMatrix4?(S.boundary=16,S.storage=64):y.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(S.boundary=16,S.storage=y.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",y),P===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(y){let P=y.target;P.removeEventListener("dispose",g),n.deleteBuffer(s[P.id]),delete s[P.id],delete r[P.id]}function d(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:d}}var DM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ki=null;function NM(){return Ki===null&&(Ki=new so(DM,16,16,Xs,Pi),Ki.name="DFG_LUT",Ki.minFilter=Dn,Ki.magFilter=Dn,Ki.wrapS=Xi,Ki.wrapT=Xi,Ki.generateMipmaps=!1,Ki.needsUpdate=!0),Ki}var Wc=class{constructor(e={}){let{canvas:t=Pp(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:p=jn}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let _=p,g=new Set([lc,ac,oc]),d=new Set([jn,Ci,uo,ur,sc,rc]),y=new Uint32Array(4),P=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},E=null,b=null,x=[],M=[],N=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ji,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let A=this,C=!1,D=null,F=null,I=null,z=null;this._outputColorSpace=kn;let X=0,B=0,he=null,Y=-1,ee=null,re=new $t,Q=new $t,ie=null,Z=new rt(0),de=0,se=t.width,ge=t.height,me=1,W=null,ne=null,le=new $t(0,0,se,ge),De=new $t(0,0,se,ge),Oe=!1,Xe=new Bs,ht=new Ul,yt=!1,zt=!1,vt=new wt,Kt=new G,mt=new $t,sn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Nt=!1;function jt(){return he===null?me:1}let V=i;function Ie(R,H){return t.getContext(R,H)}let Ke,ot,Te,Ut,We,Ze,L,w,$,xe,fe,Me,be,oe,ce,ve,k,ue,ae,Ae,Se,Ee,qe;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),V===null){let H="webgl2";if(V=Ie(H,R),V===null)throw Ie(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(R){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),Qe("WebGLRenderer: "+R.message),R}function et(){Ke=new Xv(V),Ke.init(),Se=new AM(V,Ke),ot=new Nv(V,Ke,e,Se),Te=new EM(V,Ke),ot.reversedDepthBuffer&&h&&Te.buffers.depth.setReversed(!0),F=V.createFramebuffer(),I=V.createFramebuffer(),z=V.createFramebuffer(),Ut=new $v(V),We=new uM,Ze=new TM(V,Ke,Te,We,ot,Se,Ut),L=new Wv(A),w=new J_(V),Ee=new Lv(V,w),$=new qv(V,w,Ut,Ee),xe=new Jv(V,$,w,Ee,Ut),ue=new Zv(V,ot,Ze),ce=new Uv(We),fe=new hM(A,L,Ke,ot,Ee,ce),Me=new IM(A,We),be=new dM,oe=new yM(Ke),k=new Iv(A,L,Te,xe,m,l),ve=new wM(A,xe,ot),qe=new LM(V,Ut,ot,Te),ae=new Dv(V,Ke,Ut),Ae=new Yv(V,Ke,Ut),Ut.programs=fe.programs,A.capabilities=ot,A.extensions=Ke,A.properties=We,A.renderLists=be,A.shadowMap=ve,A.state=Te,A.info=Ut}_!==jn&&(N=new jv(_,t.width,t.height,a,s,r));let _e=new hf(A,V);this.xr=_e,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let R=Ke.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Ke.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return me},this.setPixelRatio=function(R){R!==void 0&&(me=R,this.setSize(se,ge,!1))},this.getSize=function(R){return R.set(se,ge)},this.setSize=function(R,H,te=!0){if(_e.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}se=R,ge=H,t.width=Math.floor(R*me),t.height=Math.floor(H*me),te===!0&&(t.style.width=R+"px",t.style.height=H+"px"),N!==null&&N.setSize(t.width,t.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(se*me,ge*me).floor()},this.setDrawingBufferSize=function(R,H,te){se=R,ge=H,me=te,t.width=Math.floor(R*te),t.height=Math.floor(H*te),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(_===jn){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(re)},this.getViewport=function(R){return R.copy(le)},this.setViewport=function(R,H,te,J){R.isVector4?le.set(R.x,R.y,R.z,R.w):le.set(R,H,te,J),Te.viewport(re.copy(le).multiplyScalar(jt()).round())},this.getScissor=function(R){return R.copy(De)},this.setScissor=function(R,H,te,J){R.isVector4?De.set(R.x,R.y,R.z,R.w):De.set(R,H,te,J),Te.scissor(Q.copy(De).multiplyScalar(jt()).round())},this.getScissorTest=function(){return Oe},this.setScissorTest=function(R){Te.setScissorTest(Oe=R)},this.setOpaqueSort=function(R){W=R},this.setTransparentSort=function(R){ne=R},this.getClearColor=function(R){return R.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,te=!0){let J=0;if(R){let K=!1;if(he!==null){let Ce=he.texture.format;K=g.has(Ce)}if(K){let Ce=he.texture.type,Le=d.has(Ce),Re=k.getClearColor(),Ne=k.getClearAlpha(),He=Re.r,nt=Re.g,ut=Re.b;Le?(y[0]=He,y[1]=nt,y[2]=ut,y[3]=Ne,V.clearBufferuiv(V.COLOR,0,y)):(P[0]=He,P[1]=nt,P[2]=ut,P[3]=Ne,V.clearBufferiv(V.COLOR,0,P))}else J|=V.COLOR_BUFFER_BIT}H&&(J|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(J|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&V.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),D=R},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),k.dispose(),be.dispose(),oe.dispose(),Ze.dispose(),We.dispose(),L.dispose(),xe.dispose(),$.dispose(),Ee.dispose(),qe.dispose(),fe.dispose(),_e.dispose(),_e.removeEventListener("sessionstart",ka),_e.removeEventListener("sessionend",Fi),es.stop()};function Ve(R){R.preventDefault(),Zo("WebGLRenderer: Context Lost."),C=!0}function tt(){Zo("WebGLRenderer: Context Restored."),C=!1;let R=Ut.autoReset,H=ve.enabled,te=ve.autoUpdate,J=ve.needsUpdate,K=ve.type;et(),Ut.autoReset=R,ve.enabled=H,ve.autoUpdate=te,ve.needsUpdate=J,ve.type=K}function Pe(R){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function at(R){let H=R.target;H.removeEventListener("dispose",at),kt(H)}function kt(R){Gn(R),We.remove(R)}function Gn(R){let H=We.get(R).programs;H!==void 0&&(H.forEach(function(te){fe.releaseProgram(te)}),R.isShaderMaterial&&fe.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,te,J,K,Ce){H===null&&(H=sn);let Le=K.isMesh&&K.matrixWorld.determinantAffine()<0,Re=Po(R,H,te,J,K);Te.setMaterial(J,Le);let Ne=te.index,He=1;if(J.wireframe===!0){if(Ne=$.getWireframeAttribute(te),Ne===void 0)return;He=2}let nt=te.drawRange,ut=te.attributes.position,Ge=nt.start*He,ft=(nt.start+nt.count)*He;Ce!==null&&(Ge=Math.max(Ge,Ce.start*He),ft=Math.min(ft,(Ce.start+Ce.count)*He)),Ne!==null?(Ge=Math.max(Ge,0),ft=Math.min(ft,Ne.count)):ut!=null&&(Ge=Math.max(Ge,0),ft=Math.min(ft,ut.count));let Jt=ft-Ge;if(Jt<0||Jt===1/0)return;Ee.setup(K,J,Re,te,Ne);let Pt,It=ae;if(Ne!==null&&(Pt=w.get(Ne),It=Ae,It.setIndex(Pt)),K.isMesh)J.wireframe===!0?(Te.setLineWidth(J.wireframeLinewidth*jt()),It.setMode(V.LINES)):It.setMode(V.TRIANGLES);else if(K.isLine){let xn=J.linewidth;xn===void 0&&(xn=1),Te.setLineWidth(xn*jt()),K.isLineSegments?It.setMode(V.LINES):K.isLineLoop?It.setMode(V.LINE_LOOP):It.setMode(V.LINE_STRIP)}else K.isPoints?It.setMode(V.POINTS):K.isSprite&&It.setMode(V.TRIANGLES);if(K.isBatchedMesh)if(Ke.get("WEBGL_multi_draw"))It.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let xn=K._multiDrawStarts,ze=K._multiDrawCounts,ln=K._multiDrawCount,gt=Ne?w.get(Ne).bytesPerElement:1,ns=We.get(J).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)ns.setValue(V,"_gl_DrawID",cn),It.render(xn[cn]/gt,ze[cn])}else if(K.isInstancedMesh)It.renderInstances(Ge,Jt,K.count);else if(te.isInstancedBufferGeometry){let xn=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,ze=Math.min(te.instanceCount,xn);It.renderInstances(Ge,Jt,ze)}else It.render(Ge,Jt)};function Ao(R,H,te,J){D!==null&&R.isNodeMaterial&&D.setObject(J,R),yt===!0&&ce.setState(R,te,!1),R.transparent===!0&&R.side===gi&&R.forceSinglePass===!1?(R.side=Un,R.needsUpdate=!0,Oi(R,H,J),R.side=Ws,R.needsUpdate=!0,Oi(R,H,J),R.side=gi):Oi(R,H,J)}this.compile=function(R,H,te=null){te===null&&(te=R),D!==null&&D.renderStart(R,H,te),b=oe.get(te),b.init(H),M.push(b),te.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(b.pushLight(K),K.castShadow&&b.pushShadow(K))}),R!==te&&R.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(b.pushLight(K),K.castShadow&&b.pushShadow(K))}),b.setupLights(),D!==null&&D.updateLights(b.state.lightsArray),zt=this.localClippingEnabled,yt=ce.init(this.clippingPlanes,zt),yt===!0&&ce.setGlobalState(this.clippingPlanes,H),D!==null&&ve.render(b.state.shadowsArray,te,H);let J=new Set;return R.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ce=K.material;if(Ce)if(Array.isArray(Ce))for(let Le=0;Le<Ce.length;Le++){let Re=Ce[Le];Ao(Re,te,H,K),J.add(Re)}else Ao(Ce,te,H,K),J.add(Ce)}),b=M.pop(),D!==null&&D.renderEnd(),J},this.compileAsync=function(R,H,te=null){let J=this.compile(R,H,te);return new Promise(K=>{function Ce(){if(J.forEach(function(Le){let Ne=We.get(Le).currentProgram;(Ne===void 0||Ne.isReady())&&J.delete(Le)}),J.size===0){K(R);return}setTimeout(Ce,10)}Ke.get("KHR_parallel_shader_compile")!==null?Ce():setTimeout(Ce,10)})};let vr=null;function Ih(R){vr&&vr(R)}function ka(){es.stop()}function Fi(){es.start()}let es=new om;es.setAnimationLoop(Ih),typeof self<"u"&&es.setContext(self),this.setAnimationLoop=function(R){vr=R,_e.setAnimationLoop(R),R===null?es.stop():es.start()},_e.addEventListener("sessionstart",ka),_e.addEventListener("sessionend",Fi),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;D!==null&&D.renderStart(R,H);let te=_e.enabled===!0&&_e.isPresenting===!0,J=N!==null&&(he===null||te)&&N.begin(A,he);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),_e.enabled===!0&&_e.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(_e.cameraAutoUpdate===!0&&_e.updateCamera(H),H=_e.getCamera()),R.isScene===!0&&R.onBeforeRender(A,R,H,he),b=oe.get(R,M.length),b.init(H),b.state.textureUnits=Ze.getTextureUnits(),M.push(b),vt.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?ht.setFromArrayCamera(H):Xe.setFromProjectionMatrix(vt,pi,H.reversedDepth),zt=this.localClippingEnabled,yt=ce.init(this.clippingPlanes,zt),E=be.get(R,x.length),E.init(),x.push(E),this.info.render.frame++,_e.enabled===!0&&_e.isPresenting===!0){let Le=A.xr.getDepthSensingMesh();Le!==null&&ts(Le,H,-1/0,A.sortObjects)}ts(R,H,0,A.sortObjects),E.finish(),D!==null&&D.updateLights(b.state.lightsArray),A.sortObjects===!0&&E.sort(W,ne),Nt=_e.enabled===!1||_e.isPresenting===!1||_e.hasDepthSensing()===!1,Nt&&k.addToRenderList(E,R),this.info.autoReset===!0&&this.info.reset(),yt===!0&&ce.beginShadows();let K=b.state.shadowsArray;if(ve.render(K,R,H),yt===!0&&ce.endShadows(),(J&&N.hasRenderPass())===!1){let Le=E.opaque,Re=E.transmissive;if(b.setupLights(),H.isArrayCamera){let Ne=H.cameras;if(Re.length>0)for(let He=0,nt=Ne.length;He<nt;He++){let ut=Ne[He];vi(Le,Re,R,ut)}Nt&&k.render(R);for(let He=0,nt=Ne.length;He<nt;He++){let ut=Ne[He];Co(E,R,ut,ut.viewport)}}else Re.length>0&&vi(Le,Re,R,H),Nt&&k.render(R),Co(E,R,H)}he!==null&&B===0&&(Ze.updateMultisampleRenderTarget(he),Ze.updateRenderTargetMipmap(he)),J&&N.end(A),R.isScene===!0&&R.onAfterRender(A,R,H),Ee.resetDefaultState(),Y=-1,ee=null,M.pop(),M.length>0?(b=M[M.length-1],Ze.setTextureUnits(b.state.textureUnits),yt===!0&&ce.setGlobalState(A.clippingPlanes,b.state.camera)):b=null,x.pop(),x.length>0?E=x[x.length-1]:E=null,D!==null&&D.renderEnd()};function ts(R,H,te,J){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)te=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)b.pushLight(R),R.castShadow&&b.pushShadow(R);else if(R.isSprite){let Le=H.isArrayCamera?ht:Xe;if(!R.frustumCulled||R.intersectsFrustum(Le)){J&&mt.setFromMatrixPosition(R.matrixWorld).applyMatrix4(vt);let Re=xe.update(R),Ne=R.material;Ne.visible&&E.push(R,Re,Ne,te,mt.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let Le=H.isArrayCamera?ht:Xe;if(!R.frustumCulled||R.intersectsFrustum(Le)){let Re=xe.update(R),Ne=R.material;if(J&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),mt.copy(R.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),mt.copy(Re.boundingSphere.center)),mt.applyMatrix4(R.matrixWorld).applyMatrix4(vt)),Array.isArray(Ne)){let He=Re.groups;for(let nt=0,ut=He.length;nt<ut;nt++){let Ge=He[nt],ft=Ne[Ge.materialIndex];ft&&ft.visible&&E.push(R,Re,ft,te,mt.z,Ge,H)}}else Ne.visible&&E.push(R,Re,Ne,te,mt.z,null,H)}}}let Ce=R.children;for(let Le=0,Re=Ce.length;Le<Re;Le++)ts(Ce[Le],H,te,J)}function Co(R,H,te,J){let{opaque:K,transmissive:Ce,transparent:Le}=R;b.setupLightsView(te),yt===!0&&ce.setGlobalState(A.clippingPlanes,te),J&&Te.viewport(re.copy(J)),K.length>0&&Qt(K,H,te),Ce.length>0&&Qt(Ce,H,te),Le.length>0&&Qt(Le,H,te),Te.buffers.depth.setTest(!0),Te.buffers.depth.setMask(!0),Te.buffers.color.setMask(!0),Te.setPolygonOffset(!1)}function vi(R,H,te,J){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(b.state.transmissionRenderTarget[J.id]===void 0){let Ge=Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float");b.state.transmissionRenderTarget[J.id]=new oi(1,1,{generateMipmaps:!0,type:Ge?Pi:jn,minFilter:_s,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_t.workingColorSpace})}let Ce=b.state.transmissionRenderTarget[J.id],Le=J.viewport||re;Ce.setSize(Le.z*A.transmissionResolutionScale,Le.w*A.transmissionResolutionScale);let Re=A.getRenderTarget(),Ne=A.getActiveCubeFace(),He=A.getActiveMipmapLevel();A.setRenderTarget(Ce),A.getClearColor(Z),de=A.getClearAlpha(),de<1&&A.setClearColor(16777215,.5),A.clear(),Nt&&k.render(te);let nt=A.toneMapping;A.toneMapping=Ji;let ut=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),b.setupLightsView(J),yt===!0&&ce.setGlobalState(A.clippingPlanes,J),Qt(R,te,J),Ze.updateMultisampleRenderTarget(Ce),Ze.updateRenderTargetMipmap(Ce),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let ft=0,Jt=H.length;ft<Jt;ft++){let Pt=H[ft],{object:It,geometry:xn,material:ze,group:ln}=Pt;if(ze.side===gi&&It.layers.test(J.layers)){let gt=ze.side;ze.side=Un,ze.needsUpdate=!0,rn(It,te,J,xn,ze,ln),ze.side=gt,ze.needsUpdate=!0,Ge=!0}}Ge===!0&&(Ze.updateMultisampleRenderTarget(Ce),Ze.updateRenderTargetMipmap(Ce))}A.setRenderTarget(Re,Ne,He),A.setClearColor(Z,de),ut!==void 0&&(J.viewport=ut),A.toneMapping=nt}function Qt(R,H,te){let J=H.isScene===!0?H.overrideMaterial:null;for(let K=0,Ce=R.length;K<Ce;K++){let Le=R[K],{object:Re,geometry:Ne,group:He}=Le,nt=Le.material;nt.allowOverride===!0&&J!==null&&(nt=J),Re.layers.test(te.layers)&&rn(Re,H,te,Ne,nt,He)}}function rn(R,H,te,J,K,Ce){D!==null&&K.isNodeMaterial&&D.setObject(R,K),R.onBeforeRender(A,H,te,J,K,Ce),R.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),K.onBeforeRender(A,H,te,J,R,Ce),K.transparent===!0&&K.side===gi&&K.forceSinglePass===!1?(K.side=Un,K.needsUpdate=!0,A.renderBufferDirect(te,H,J,K,R,Ce),K.side=Ws,K.needsUpdate=!0,A.renderBufferDirect(te,H,J,K,R,Ce),K.side=gi):A.renderBufferDirect(te,H,J,K,R,Ce),R.onAfterRender(A,H,te,J,K,Ce)}function on(R){let H=0;for(let te of R)te.texture!==null&&H++;return H}function Oi(R,H,te){H.isScene!==!0&&(H=sn);let J=We.get(R),K=b.state.lights,Ce=b.state.shadowsArray,Le=K.state.version,Re=fe.getParameters(R,K.state,Ce,H,te,b.state.lightProbeGridArray),Ne=fe.getProgramCacheKey(Re),He=J.programs;J.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,J.fog=H.fog;let nt=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;J.envMap=L.get(R.envMap||J.environment,nt),J.envMapRotation=J.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,He===void 0&&(R.addEventListener("dispose",at),He=new Map,J.programs=He,J.programVariants=new Map);let ut=He.get(Ne);if(ut!==void 0){if(J.currentProgram===ut&&J.lightsStateVersion===Le)return Ro(R,Re),ut}else Re.uniforms=fe.getUniforms(R),D!==null&&R.isNodeMaterial&&D.build(R,te,Re),R.onBeforeCompile(Re,A),ut=fe.acquireProgram(Re,Ne),He.set(Ne,ut),J.uniforms=Re.uniforms;let Ge=J.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ge.clippingPlanes=ce.uniform),Ro(R,Re),J.needsLights=Ts(R),J.lightsStateVersion=Le,J.needsLights&&(Ge.ambientLightColor.value=K.state.ambient,Ge.lightProbe.value=K.state.probe,Ge.sunLights.value=K.state.sun,Ge.sunLightShadows.value=K.state.sunShadow,Ge.directionalLights.value=K.state.directional,Ge.directionalLightShadows.value=K.state.directionalShadow,Ge.spotLights.value=K.state.spot,Ge.spotLightShadows.value=K.state.spotShadow,Ge.rectAreaLights.value=K.state.rectArea,Ge.ltc_1.value=K.state.rectAreaLTC1,Ge.ltc_2.value=K.state.rectAreaLTC2,Ge.pointLights.value=K.state.point,Ge.pointLightShadows.value=K.state.pointShadow,Ge.hemisphereLights.value=K.state.hemi,Ge.sunShadowMatrix.value=K.state.sunShadowMatrix,Ge.sunShadowCascade.value=K.state.sunShadowCascade,Ge.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ge.spotLightMatrix.value=K.state.spotLightMatrix,Ge.spotLightMap.value=K.state.spotLightMap,Ge.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=on(b.state.lightProbeGridArray),J.currentProgram=ut,J.uniformsList=null,ut}function ei(R,H,te,J,K){let Ce=We.get(R),Le=Ce.currentProgram.id+","+J+","+K,Re=Ce.programVariants.get(Le);return Re===void 0?(Re=Oi(R,H,te),Ce.programVariants.set(Le,Re)):(Ce.currentProgram=Re,Ce.uniformsList=null,Ce.outputColorSpace=J,Ce.toneMapping=K),Re}function Es(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=fo.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function Ro(R,H){let te=We.get(R);te.outputColorSpace=H.outputColorSpace,te.batching=H.batching,te.batchingColor=H.batchingColor,te.instancing=H.instancing,te.instancingColor=H.instancingColor,te.instancingMorph=H.instancingMorph,te.skinning=H.skinning,te.morphTargets=H.morphTargets,te.morphNormals=H.morphNormals,te.morphColors=H.morphColors,te.morphTargetsCount=H.morphTargetsCount,te.numClippingPlanes=H.numClippingPlanes,te.numIntersection=H.numClipIntersection,te.vertexAlphas=H.vertexAlphas,te.vertexTangents=H.vertexTangents,te.toneMapping=H.toneMapping}function Po(R,H,te,J,K){H.isScene!==!0&&(H=sn),Ze.resetTextureUnits();let Ce=H.fog,Le=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?H.environment:null,Re=he===null?A.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:_t.workingColorSpace,Ne=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,He=L.get(J.envMap||Le,Ne),nt=J.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,ut=!!te.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Ge=!!te.morphAttributes.position,ft=!!te.morphAttributes.normal,Jt=!!te.morphAttributes.color,Pt=Ji;J.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(Pt=A.toneMapping);let It=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,xn=It!==void 0?It.length:0,ze=We.get(J),ln=b.state.lights;if(yt===!0&&(zt===!0||R!==ee)){let Lt=R===ee&&J.id===Y;ce.setState(J,R,Lt)}let gt=!1,ns=!1;J.version===ze.__version?ze.needsLights&&ze.lightsStateVersion!==ln.state.version||K.isBatchedMesh&&ze.batching===!1||!K.isBatchedMesh&&ze.batching===!0||K.isBatchedMesh&&ze.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&ze.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&ze.instancing===!1||!K.isInstancedMesh&&ze.instancing===!0||K.isSkinnedMesh&&ze.skinning===!1||!K.isSkinnedMesh&&ze.skinning===!0||K.isInstancedMesh&&ze.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&ze.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&ze.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&ze.instancingMorph===!1&&K.morphTexture!==null||ze.envMap!==He||J.fog===!0&&ze.fog!==Ce||ze.numClippingPlanes!==void 0&&(ze.numClippingPlanes!==ce.numPlanes||ze.numIntersection!==ce.numIntersection)||ze.vertexAlphas!==nt||ze.vertexTangents!==ut||ze.morphTargets!==Ge||ze.morphNormals!==ft||ze.morphColors!==Jt||ze.morphTargetsCount!==xn||ze.numLightProbeGrids!==on(b.state.lightProbeGridArray)?gt=!0:(ze.outputColorSpace!==Re||ze.toneMapping!==Pt)&&(ns=!0):(gt=!0,ze.__version=J.version);let cn=ze.currentProgram;(gt===!0||ns===!0)&&(cn=ns===!0?ei(J,H,K,Re,Pt):Oi(J,H,K),D&&J.isNodeMaterial&&D.onUpdateProgram(J,cn,ze));let br=!1,Bi=!1,is=!1,lt=cn.getUniforms(),en=ze.uniforms;if(Te.useProgram(cn.program)&&(br=!0,Bi=!0,is=!0),J.id!==Y&&(Y=J.id,Bi=!0),br||ee!==R){Te.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),lt.setValue(V,"projectionMatrix",R.projectionMatrix),lt.setValue(V,"viewMatrix",R.matrixWorldInverse);let hn=lt.map.cameraPosition;hn!==void 0&&hn.setValue(V,Kt.setFromMatrixPosition(R.matrixWorld)),ot.logarithmicDepthBuffer&&lt.setValue(V,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&lt.setValue(V,"isOrthographic",R.isOrthographicCamera===!0),ee!==R&&(ee=R,Bi=!0,is=!0)}if(ze.needsLights&&(ln.state.sunShadowMap.length>0&&lt.setValue(V,"sunShadowMap",ln.state.sunShadowMap,Ze),ln.state.directionalShadowMap.length>0&&lt.setValue(V,"directionalShadowMap",ln.state.directionalShadowMap,Ze),ln.state.spotShadowMap.length>0&&lt.setValue(V,"spotShadowMap",ln.state.spotShadowMap,Ze),ln.state.pointShadowMap.length>0&&lt.setValue(V,"pointShadowMap",ln.state.pointShadowMap,Ze)),K.isSkinnedMesh){lt.setOptional(V,K,"bindMatrix"),lt.setOptional(V,K,"bindMatrixInverse");let Lt=K.skeleton;Lt&&(Lt.boneTexture===null&&Lt.computeBoneTexture(),lt.setValue(V,"boneTexture",Lt.boneTexture,Ze))}K.isBatchedMesh&&(lt.setOptional(V,K,"batchingTexture"),lt.setValue(V,"batchingTexture",K._matricesTexture,Ze),lt.setOptional(V,K,"batchingIdTexture"),lt.setValue(V,"batchingIdTexture",K._indirectTexture,Ze),lt.setOptional(V,K,"batchingColorTexture"),K._colorsTexture!==null&&lt.setValue(V,"batchingColorTexture",K._colorsTexture,Ze));let Hn=te.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&ue.update(K,te,cn),(Bi||ze.receiveShadow!==K.receiveShadow)&&(ze.receiveShadow=K.receiveShadow,lt.setValue(V,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&H.environment!==null&&(en.envMapIntensity.value=H.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=NM()),Bi){if(lt.setValue(V,"toneMappingExposure",A.toneMappingExposure),ze.needsLights&&Sr(en,is),Ce&&J.fog===!0&&Me.refreshFogUniforms(en,Ce),Me.refreshMaterialUniforms(en,J,me,ge,b.state.transmissionRenderTarget[R.id]),ze.needsLights&&ze.numLightProbeGrids>0){let Lt=S,hn=0;for(let On of b.state.lightProbeGridArray)On.texture!==null&&(Lt.textures[hn]=On.texture,Lt.min[hn]=On.boundingBox.min,Lt.max[hn]=On.boundingBox.max,Lt.resolution[hn]=On.resolution,hn++);for(let On in Lt)Lt[On].length=hn;en.probesSH.value=Lt.textures,en.probesMin.value=Lt.min,en.probesMax.value=Lt.max,en.probesResolution.value=Lt.resolution}fo.upload(V,Es(ze),en,Ze)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(fo.upload(V,Es(ze),en,Ze),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&lt.setValue(V,"center",K.center),lt.setValue(V,"modelViewMatrix",K.modelViewMatrix),lt.setValue(V,"normalMatrix",K.normalMatrix),lt.setValue(V,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Lt=J.uniformsGroups;for(let hn=0,On=Lt.length;hn<On;hn++){let Va=Lt[hn];qe.update(Va,cn),qe.bind(Va,cn)}}return cn}function Sr(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function Ts(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return he},this.setRenderTargetTextures=function(R,H,te){let J=We.get(R);J.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),We.get(R.texture).__webglTexture=H,We.get(R.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:te,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let te=We.get(R);te.__webglFramebuffer=H,te.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,te=0){he=R,X=H,B=te;let J=null,K=!1,Ce=!1;if(R){let Re=We.get(R);if(Re.__useDefaultFramebuffer!==void 0){Te.bindFramebuffer(V.FRAMEBUFFER,Re.__webglFramebuffer),re.copy(R.viewport),Q.copy(R.scissor),ie=R.scissorTest,Te.viewport(re),Te.scissor(Q),Te.setScissorTest(ie),Y=-1;return}else if(Re.__webglFramebuffer===void 0)Ze.setupRenderTarget(R);else if(Re.__hasExternalTextures)Ze.rebindTextures(R,We.get(R.texture).__webglTexture,We.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let nt=R.depthTexture;if(Re.__boundDepthTexture!==nt){if(nt!==null&&We.has(nt)&&(R.width!==nt.image.width||R.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(R)}}let Ne=R.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ce=!0);let He=We.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(He[H])?J=He[H][te]:J=He[H],K=!0):R.samples>0&&Ze.useMultisampledRTT(R)===!1?J=We.get(R).__webglMultisampledFramebuffer:Array.isArray(He)?J=He[te]:J=He,re.copy(R.viewport),Q.copy(R.scissor),ie=R.scissorTest}else re.copy(le).multiplyScalar(me).floor(),Q.copy(De).multiplyScalar(me).floor(),ie=Oe;if(te!==0&&(J=F),Te.bindFramebuffer(V.FRAMEBUFFER,J)&&Te.drawBuffers(R,J),Te.viewport(re),Te.scissor(Q),Te.setScissorTest(ie),K){let Re=We.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+H,Re.__webglTexture,te)}else if(Ce){let Re=H;for(let Ne=0;Ne<R.textures.length;Ne++){let He=We.get(R.textures[Ne]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Ne,He.__webglTexture,te,Re)}}else if(R!==null&&te!==0){let Re=We.get(R.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Re.__webglTexture,te)}Y=-1};function Mr(R){let H=We.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=ot.textureFormatReadable(R.format),H.__typeReadable=ot.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,te,J,K,Ce,Le,Re=0){if(!(R&&R.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=We.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Te.bindFramebuffer(V.FRAMEBUFFER,Ne);try{let He=R.textures[Re],nt=He.format,ut=He.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Re);let Ge=Mr(He);if(Ge.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-J&&te>=0&&te<=R.height-K&&V.readPixels(H,te,J,K,Se.convert(nt),Se.convert(ut),Ce)}finally{let He=he!==null?We.get(he).__webglFramebuffer:null;Te.bindFramebuffer(V.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(R,H,te,J,K,Ce,Le,Re=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=We.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(H>=0&&H<=R.width-J&&te>=0&&te<=R.height-K){Te.bindFramebuffer(V.FRAMEBUFFER,Ne);let He=R.textures[Re],nt=He.format,ut=He.type;R.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Re);let Ge=Mr(He);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ft=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,ft),V.bufferData(V.PIXEL_PACK_BUFFER,Ce.byteLength,V.STREAM_READ),V.readPixels(H,te,J,K,Se.convert(nt),Se.convert(ut),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let Jt=he!==null?We.get(he).__webglFramebuffer:null;Te.bindFramebuffer(V.FRAMEBUFFER,Jt);let Pt=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await Lp(V,Pt,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,ft),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,Ce),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(ft),V.deleteSync(Pt),Ce}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,te=0){let J=Math.pow(2,-te),K=Math.floor(R.image.width*J),Ce=Math.floor(R.image.height*J),Le=H!==null?H.x:0,Re=H!==null?H.y:0;Ze.setTexture2D(R,0),V.copyTexSubImage2D(V.TEXTURE_2D,te,0,0,Le,Re,K,Ce),Te.unbindTexture()},this.copyTextureToTexture=function(R,H,te=null,J=null,K=0,Ce=0){let Le,Re,Ne,He,nt,ut,Ge,ft,Jt,Pt=R.isCompressedTexture?R.mipmaps[Ce]:R.image;if(te!==null)Le=te.max.x-te.min.x,Re=te.max.y-te.min.y,Ne=te.isBox3?te.max.z-te.min.z:1,He=te.min.x,nt=te.min.y,ut=te.isBox3?te.min.z:0;else{let lt=Math.pow(2,-K);Le=Math.floor(Pt.width*lt),Re=Math.floor(Pt.height*lt),R.isDataArrayTexture?Ne=Pt.depth:R.isData3DTexture?Ne=Math.floor(Pt.depth*lt):Ne=1,He=0,nt=0,ut=0}J!==null?(Ge=J.x,ft=J.y,Jt=J.z):(Ge=0,ft=0,Jt=0);let It=Se.convert(H.format),xn=Se.convert(H.type),ze;H.isData3DTexture?(Ze.setTexture3D(H,0),ze=V.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Ze.setTexture2DArray(H,0),ze=V.TEXTURE_2D_ARRAY):(Ze.setTexture2D(H,0),ze=V.TEXTURE_2D),Te.activeTexture(V.TEXTURE0),Te.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,H.flipY),Te.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Te.pixelStorei(V.UNPACK_ALIGNMENT,H.unpackAlignment);let ln=Te.getParameter(V.UNPACK_ROW_LENGTH),gt=Te.getParameter(V.UNPACK_IMAGE_HEIGHT),ns=Te.getParameter(V.UNPACK_SKIP_PIXELS),cn=Te.getParameter(V.UNPACK_SKIP_ROWS),br=Te.getParameter(V.UNPACK_SKIP_IMAGES);Te.pixelStorei(V.UNPACK_ROW_LENGTH,Pt.width),Te.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Pt.height),Te.pixelStorei(V.UNPACK_SKIP_PIXELS,He),Te.pixelStorei(V.UNPACK_SKIP_ROWS,nt),Te.pixelStorei(V.UNPACK_SKIP_IMAGES,ut);let Bi=R.isDataArrayTexture||R.isData3DTexture,is=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let lt=We.get(R),en=We.get(H),Hn=We.get(lt.__renderTarget),Lt=We.get(en.__renderTarget);Te.bindFramebuffer(V.READ_FRAMEBUFFER,Hn.__webglFramebuffer),Te.bindFramebuffer(V.DRAW_FRAMEBUFFER,Lt.__webglFramebuffer);for(let hn=0;hn<Ne;hn++)Bi&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,We.get(R).__webglTexture,K,ut+hn),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,We.get(H).__webglTexture,Ce,Jt+hn)),V.blitFramebuffer(He,nt,He+Le,nt+Re,Ge,ft,Ge+Le,ft+Re,V.DEPTH_BUFFER_BIT,V.NEAREST);Te.bindFramebuffer(V.READ_FRAMEBUFFER,null),Te.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(K!==0||R.isRenderTargetTexture||We.has(R)){let lt=We.get(R),en=We.get(H);Te.bindFramebuffer(V.READ_FRAMEBUFFER,I),Te.bindFramebuffer(V.DRAW_FRAMEBUFFER,z);for(let Hn=0;Hn<Ne;Hn++)Bi?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,lt.__webglTexture,K,ut+Hn):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,lt.__webglTexture,K),is?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,en.__webglTexture,Ce,Jt+Hn):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,en.__webglTexture,Ce),K!==0?V.blitFramebuffer(He,nt,He+Le,nt+Re,Ge,ft,Ge+Le,ft+Re,V.COLOR_BUFFER_BIT,V.NEAREST):is?V.copyTexSubImage3D(ze,Ce,Ge,ft,Jt+Hn,He,nt,Le,Re):V.copyTexSubImage2D(ze,Ce,Ge,ft,He,nt,Le,Re);Te.bindFramebuffer(V.READ_FRAMEBUFFER,null),Te.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else is?R.isDataTexture||R.isData3DTexture?V.texSubImage3D(ze,Ce,Ge,ft,Jt,Le,Re,Ne,It,xn,Pt.data):H.isCompressedArrayTexture?V.compressedTexSubImage3D(ze,Ce,Ge,ft,Jt,Le,Re,Ne,It,Pt.data):V.texSubImage3D(ze,Ce,Ge,ft,Jt,Le,Re,Ne,It,xn,Pt):R.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,Ce,Ge,ft,Le,Re,It,xn,Pt.data):R.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,Ce,Ge,ft,Pt.width,Pt.height,It,Pt.data):V.texSubImage2D(V.TEXTURE_2D,Ce,Ge,ft,Le,Re,It,xn,Pt);Te.pixelStorei(V.UNPACK_ROW_LENGTH,ln),Te.pixelStorei(V.UNPACK_IMAGE_HEIGHT,gt),Te.pixelStorei(V.UNPACK_SKIP_PIXELS,ns),Te.pixelStorei(V.UNPACK_SKIP_ROWS,cn),Te.pixelStorei(V.UNPACK_SKIP_IMAGES,br),Ce===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&V.generateMipmap(ze),Te.unbindTexture()},this.initRenderTarget=function(R){We.get(R).__webglFramebuffer===void 0&&Ze.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Ze.setTextureCube(R,0):R.isData3DTexture?Ze.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Ze.setTexture2DArray(R,0):Ze.setTexture2D(R,0),Te.unbindTexture()},this.resetState=function(){X=0,B=0,he=null,Te.reset(),Ee.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return pi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}};var UM="http://www.w3.org/2000/svg",FM=["#b3261e","#2e7d32","#1652b8"],[xm,_m,Yc,uf]=[300,62,5,4],OM=32768;function _i(n,e,t,i){let s=document.createElementNS(UM,e);for(let[r,o]of Object.entries(t))s.setAttribute(r,o);return i!==void 0&&(s.textContent=i),n.append(s),s}function $c(n,e){let t=(xm-_m)/2;return _m+t+Math.sign(n)*t*Math.asinh(Math.abs(n)/e)/Math.asinh(OM/e)}function ym(n,e){n.replaceChildren();let t=3*Yc+uf,i=e.length*t+uf+20;n.setAttribute("viewBox",`0 0 ${xm} ${i}`);let s=Math.min(...e[0].noise);for(let r of[-1e4,-1e3,-100,0,100,1e3,1e4]){let o=$c(r,s);_i(n,"line",{x1:o,x2:o,y1:0,y2:i-18,stroke:r?"#e2e2dc":"#555"});let a=Math.abs(r)>=1e3?`${r/1e3}k`:`${r}`;_i(n,"text",{x:o,y:i-6,"font-size":9,"text-anchor":"middle",fill:"#555"},a.replace("-","\u2212"))}e.forEach(({face:r,counts:o,live:a,noise:l,number:c},u)=>{let f=u*t+uf;_i(n,"text",{x:0,y:f+12,"font-size":10,fill:"#333"},`F${r}-S${c}`),o.forEach((h,p)=>{if(!a[p])return;let[m,_,g]=[$c(0,s),$c(l[p],s),$c(h,s)],d=f+p*Yc+1;_i(n,"rect",{x:2*m-_,width:2*(_-m),y:d,height:Yc-1,fill:"#d9d9d2"});let y={x:Math.min(m,g),width:Math.abs(g-m),y:d,height:Yc-1.5,fill:FM[p]};_i(n,"rect",{...y,opacity:Math.abs(h)<l[p]?.35:1})})})}function vm(n,e){n.replaceChildren(...e.map(({face:t,number:i,counts:s,live:r})=>{let o=document.createElement("tr");return[t,i,...s.map((l,c)=>r[c]?Math.round(l):"\u2013")].forEach(l=>o.insertCell().append(String(l))),o}))}var Zc=["440154","482475","414487","355f8d","2a788e","21918c","22a884","44bf70","7ad151","bddf26","fde725"].map(n=>new rt(`#${n}`));function BM(n,e){let t=Math.min(.9999,Math.max(0,n))*(Zc.length-1);return e.lerpColors(Zc[Math.floor(t)],Zc[Math.floor(t)+1],t%1)}function zM({content:n,arrays:e}){let t=Kn(e.silicone_normals),i=new Int8Array(t.length/3).fill(-1),s=new Float32Array(i.length).fill(-2),{link_vertex:r,link_source:o}=e;return r.data.forEach((a,l)=>{let c=kM(n,o.data[l]),u=n.faces[c].normal,f=u[0]*t[3*a]+u[1]*t[3*a+1]+u[2]*t[3*a+2];f>Math.max(s[a],.3)&&([i[a],s[a]]=[c,f])}),i}function kM(n,e){let t=0;for(let i=e;i>=n.face_vertices[t];t++)i-=n.face_vertices[t];return t}function Ca(n,e,t,i){let[s,r,o]=[e-n.centre_mm[0],t-n.centre_mm[1],i-n.centre_mm[2]];return[n.x,n.y].map((a,l)=>Sm(n.sections?.[l],"plane_mm","length_mm",s*a[0]+r*a[1]+o*a[2]))}function ff(n,e){return e.map((t,i)=>Sm(n.sections?.[i],"length_mm","plane_mm",t))}function Sm(n,e,t,i){if(!n)return i;let[s,r]=[n[e],n[t]],o=s.findIndex(l=>l>i),a=Math.max(1,o<0?s.length-1:o);return r[a-1]+(i-s[a-1])*(r[a]-r[a-1])/(s[a]-s[a-1])}function Zt(n){if(!Number.isFinite(n))return"\u2013";let e=Math.abs(n);return e>=1e4||e<.001&&e>0?n.toExponential(1):n.toPrecision(3)}function VM({content:n,arrays:e},t){let i=Kn(e.silicone_mm),s=new Float32Array(i.length).fill(-1),r=l=>l.length>1?l[1]-l[0]:1,{x_mm:o,y_mm:a}=n.grid;return t.forEach((l,c)=>{if(l<0)return;let[u,f]=Ca(n.faces[l],...i.subarray(3*c,3*c+3));s.set([(u-o[0])/r(o),(f-a[0])/r(a),l],3*c)}),s}var GM=`attribute vec3 chart; varying vec4 onFace;
`,HM=`varying vec4 onFace; uniform sampler2D score; uniform vec3 grid; uniform float mapped;
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
`;function WM(n,e){n.onBeforeCompile=t=>{Object.assign(t.uniforms,e),t.vertexShader=GM+t.vertexShader.replace("#include <begin_vertex>",`#include <begin_vertex>
onFace = vec4(chart, chart.z * chart.z);`),t.fragmentShader=HM+t.fragmentShader.replace("#include <color_fragment>","diffuseColor.rgb = mapColour(diffuseColor.rgb);")},n.needsUpdate=!0}function Jc(n,e,t){let{content:i,arrays:s}=n,r=zM(n),[o,a,l]=[i.grid.x_mm.length,i.grid.y_mm.length,i.faces.length],c=o*a,u=new so(new Uint8Array(4*c*l),o,a*l);u.magFilter=u.minFilter=Dn,u.colorSpace=kn;let f={score:{value:u},grid:{value:new G(o,a,l)},mapped:{value:0}};e.silicone.front.geometry.setAttribute("chart",new Ln(VM(n,r),3)),WM(e.silicone.front.material,f);let h=null,p={};function m(S){if(p[S.stem])return p[S.stem];let E=Array.from(s[`map_${S.stem}`].data).filter(b=>Number.isFinite(b)&&(!S.log||b>0));return[Math.min(...E),Math.max(...E)]}function _(S){let E=m(S),[b,x]=S.log?E.map(Math.log):E,M=A=>((S.log?Math.log(A):A)-b)/(x-b||1);return{share:A=>S.weak==="high"?1-M(A):M(A),at:A=>{let C=b+A*(x-b);return S.log?Math.exp(C):C}}}function g(S){return h=i.maps.find(E=>E.stem===S)??null,f.mapped.value=h?1:0,h&&d(_(h),s[`map_${S}`].data),t.redraw(),h&&{map:h,at:_(h).at}}function d(S,E){let b=new rt,x={};E.forEach((M,N)=>{let[A,C]=[Math.floor(N/c),N%c],D=4*((A*a+C%a)*o+Math.floor(C/a));u.image.data.fill(0,D,D+4),Number.isFinite(M)&&(BM(S.share(M),b).getRGB(x,kn),u.image.data.set([x.r,x.g,x.b,1].map(F=>255*F),D))}),u.needsUpdate=!0}return{owner:r,show:g,valueAt:(S,E)=>h&&s[`map_${h.stem}`].data[S*c+E],shown:()=>h,endsOf:m,fix:(S,E)=>p[S]=E}}function Kc(n,e){if(n.hidden=!e,!e)return;let t=Zc.map(l=>`#${l.getHexString()}`);e.map.weak==="high"&&t.reverse(),n.querySelector(".scale").style.background=`linear-gradient(to right, ${t})`;let i=n.querySelectorAll(".ticks span");i.forEach((l,c)=>{let u=Zt(e.at(c/(i.length-1)));l.textContent!==u&&(l.textContent=u)});let{title:s,unit:r,log:o,force_n:a}=e.map;n.querySelector(".title").textContent=`${s}, ${r} at ${a} N${o?", logarithmic":""}. Dark is weak; grey: not judged.`}var XM=1e-6,[jc,mo,Qc,eh]=[300,230,46,40];function Mm(n,{objectives:e,trials:t,layouts:i},s){n.setAttribute("viewBox",`0 0 ${jc} ${mo}`);let r=i.map((m,_)=>[...m.scores.slice(0,2),_]).filter(m=>!m.includes(null)),o=m=>Math.log(Math.max(m,XM)),a=[0,1].map(m=>{let _=[...t,...r].map(g=>o(g[m]));return[Math.min(..._),Math.max(..._)]}),l=(m,_)=>(o(m)-a[_][0])/(a[_][1]-a[_][0]||1),c=m=>Qc+8+l(m,0)*(jc-Qc-16),u=m=>mo-eh-8-l(m,1)*(mo-eh-16),f=(m,_)=>_i(n,"text",{"font-size":9,fill:"#444",..._},m);_i(n,"path",{d:`M${Qc} 0V${mo-eh}H${jc}`,fill:"none",stroke:"#555"});for(let m of[0,.5,1]){let[_,g]=a.map(([d,y])=>Math.exp(d+m*(y-d)));f(Zt(_),{x:c(_),y:mo-eh+12,"text-anchor":"middle"}),f(Zt(g),{x:Qc-4,y:u(g)+3,"text-anchor":"end"})}f(e[0],{x:jc,y:mo-12,"text-anchor":"end"}),f(e[1],{x:0,y:0,"text-anchor":"end",transform:"translate(9 0) rotate(-90)"});for(let[m,_]of t)_i(n,"circle",{cx:c(m),cy:u(_),r:1.6,fill:"#9a968d"});let h=r.map(([m,_,g])=>{let d=g?_i(n,"circle",{cx:c(m),cy:u(_),r:4.5,stroke:"#1652b8","stroke-width":1.5,class:"choice","data-layout":g}):_i(n,"path",{d:`M${c(m)-4} ${u(_)-4}l8 8m0 -8l-8 8`,stroke:"#1c1c1c","stroke-width":2});return _i(d,"title",{},`${i[g].label}: ${Zt(m)}, ${Zt(_)}`),g&&d.addEventListener("click",()=>s(g)),d});return{mark:m=>h.forEach(_=>_.setAttribute("fill",Number(_.dataset.layout)===m?"#1652b8":"#fff"))}}var bm={type:"change"},pf={type:"start"},Em={type:"end"},th=new Fs,wm=new In,qM=Math.cos(70*Zu.DEG2RAD),Sn=new G,Qn=2*Math.PI,Tt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},df=1e-6,nh=class extends ma{constructor(e,t=null){super(e,t),this.state=Tt.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Gs.ROTATE,MIDDLE:Gs.DOLLY,RIGHT:Gs.PAN},this.touches={ONE:Hs.ROTATE,TWO:Hs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new an,this._lastTargetPosition=new G,this._quat=new an().setFromUnitVectors(e.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ao,this._sphericalDelta=new ao,this._scale=1,this._panOffset=new G,this._rotateStart=new Ye,this._rotateEnd=new Ye,this._rotateDelta=new Ye,this._panStart=new Ye,this._panEnd=new Ye,this._panDelta=new Ye,this._dollyStart=new Ye,this._dollyEnd=new Ye,this._dollyDelta=new Ye,this._dollyDirection=new G,this._mouse=new Ye,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=$M.bind(this),this._onPointerDown=YM.bind(this),this._onPointerUp=ZM.bind(this),this._onContextMenu=nb.bind(this),this._onMouseWheel=jM.bind(this),this._onKeyDown=QM.bind(this),this._onTouchStart=eb.bind(this),this._onTouchMove=tb.bind(this),this._onMouseDown=JM.bind(this),this._onMouseMove=KM.bind(this),this._interceptControlDown=ib.bind(this),this._interceptControlUp=sb.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Tt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(bm),this.update(),this.state=Tt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Sn.copy(t).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Tt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Qn:i>Math.PI&&(i-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(th.origin.copy(this.object.position),th.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(th.direction))<qM?this.object.lookAt(this.target):(wm.setFromNormalAndCoplanarPoint(this.object.up,this.target),th.intersectPlane(wm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>df||8*(1-this._lastQuaternion.dot(this.object.quaternion))>df||this._lastTargetPosition.distanceToSquared(this.target)>df?(this.dispatchEvent(bm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Qn/60*this.autoRotateSpeed*e:Qn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Sn.setFromMatrixColumn(t,0),Sn.multiplyScalar(-e),this._panOffset.add(Sn)}_panUp(e,t){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(t,1):(Sn.setFromMatrixColumn(t,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(e),this._panOffset.add(Sn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ye,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function YM(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function $M(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function ZM(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Em),this.state=Tt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function JM(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Gs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Tt.DOLLY;break;case Gs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Tt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Tt.ROTATE}break;case Gs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Tt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Tt.PAN}break;default:this.state=Tt.NONE}this.state!==Tt.NONE&&this.dispatchEvent(pf)}function KM(n){switch(this.state){case Tt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Tt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Tt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function jM(n){this.enabled===!1||this.enableZoom===!1||this.state!==Tt.NONE||(n.preventDefault(),this.dispatchEvent(pf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Em))}function QM(n){this.enabled!==!1&&this._handleKeyDown(n)}function eb(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Hs.ROTATE:if(this.enableRotate===!1){this.state=Tt.NONE;break}this._handleTouchStartRotate(n),this.state=Tt.TOUCH_ROTATE;break;case Hs.PAN:if(this.enablePan===!1){this.state=Tt.NONE;break}this._handleTouchStartPan(n),this.state=Tt.TOUCH_PAN;break;default:this.state=Tt.NONE}break;case 2:switch(this.touches.TWO){case Hs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Tt.TOUCH_DOLLY_PAN;break;case Hs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Tt.TOUCH_DOLLY_ROTATE;break;default:this.state=Tt.NONE}break;default:this.state=Tt.NONE}this.state!==Tt.NONE&&this.dispatchEvent(pf)}function tb(n){switch(this._trackPointer(n),this.state){case Tt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Tt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Tt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Tt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Tt.NONE}}function nb(n){this.enabled!==!1&&n.preventDefault()}function ib(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function sb(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var rb=new G(0,1,0);function ih(n,e,t=!1){let i=new Os({color:n,depthTest:!t,transparent:t}),s=new Et(new $i(e,e,1,10),i),r=new Et(new oa(2.6*e,6*e,14),i),o=new Xt;o.add(s,r),t&&(s.renderOrder=r.renderOrder=5);function a(l,c,u){o.visible=u>1e-6;let f=Math.max(u-6*e,.001);o.position.copy(l),o.quaternion.setFromUnitVectors(rb,c),s.scale.y=f,s.position.y=f/2,r.scale.setScalar(Math.min(1,u/(6*e))||1),r.position.y=Math.max(u,.001)-3*e*r.scale.x}return{object:o,point:a}}var ob=16250868,sh=.12,ab=40,lb=250,cb=.4;function dr(n,e,t="#1c1c1c"){let i=document.createElement("canvas");i.width=i.height=64;let s=i.getContext("2d");s.font="600 44px system-ui, sans-serif",s.textAlign="center",s.textBaseline="middle",s.lineWidth=8,s.strokeStyle="rgba(255,255,255,.85)",s.strokeText(n,32,34),s.fillStyle=t,s.fillText(n,32,34);let r=new io({map:new ia(i),depthTest:!1}),o=new ta(r);return o.scale.setScalar(e),o.renderOrder=10,o}function go(n,e){return e.position.clone().sub(new G(...n.centre_mm)).dot(new G(...n.normal))>0}function hb(n,e){let t=new Xt,i=[11740702,3046706,1462968];return["x","y","z"].forEach((s,r)=>{let o=new G().setComponent(r,1),a=ih(i[r],n/90);a.point(e,o,n/4),t.add(a.object);let l=dr(s,n/9,`#${new rt(i[r]).getHexString()}`);l.position.copy(e).addScaledVector(o,n/3.4),t.add(l)}),t}function ub(){let n=document.createElement("canvas").getContext("webgl2");if(!n)return!1;let e=n.getExtension("WEBGL_debug_renderer_info"),t=e?n.getParameter(e.UNMASKED_RENDERER_WEBGL):"";return n.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software/i.test(t)}function fb(n,e,t){let i=t?.6:1,[s,r]=[0,0],o=()=>Math.min(devicePixelRatio,2);function a(){r=0,n.getPixelRatio()!==o()&&e()}function l(){r||(s=0),clearTimeout(r),r=setTimeout(a,lb)}function c(u){r&&s&&u-s>ab&&(i=Math.max(cb,.85*i)),s=u;let f=o()*(r?i:1);n.getPixelRatio()!==f&&n.setPixelRatio(f)}return{moved:l,settle:c}}function Ys(n,e){let t=ub(),i=new Wc({canvas:n,antialias:!t});i.setClearColor(ob),i.localClippingEnabled=!0;let s=new Ko,r=.58*Math.hypot(...e),o=new $n(30,1,r/50,r*30);o.up.set(0,0,1);let a=new nh(o,n),l=new fa(16777215,2.1);l.position.set(-.5,.65,.8),o.add(l,l.target),l.target.position.set(0,0,-1),s.add(o,new da(16777215,1.5));let c=new pa(Math.ceil(3*r/20)*20,Math.ceil(3*r/20)*2,12171698,14737626);c.rotation.x=Math.PI/2,c.position.z=-e[2]/2-r*.02;let u=new Xt;u.add(c,hb(r,new G(-.8*r,-.8*r,c.position.z))),s.add(u);let f=[],h=!1,p=0;function m(E){h=!1,g.settle(E??performance.now()),f.forEach(b=>b(o)),i.render(s,o),p+=1}function _(){h||requestAnimationFrame(m),h=!0}let g=fb(i,_,t);function d(E=4.3,b=0,x=!1){let M=x?o.position.clone().sub(a.target):new G(.57,-.68,.46),N=Math.max(1,1.25/o.aspect);a.target.set(0,0,b*r),o.position.copy(a.target).addScaledVector(M.normalize(),E*r*N),a.update(),_()}function y({center:E,radius:b}){d(1);let x=Math.min(1,o.aspect)*Math.sin(o.fov*Math.PI/360),M=o.position.clone().sub(a.target).normalize();a.target.copy(E),o.position.copy(E).addScaledVector(M,b/x),a.update()}function P(){let{clientWidth:E,clientHeight:b}=n;!E||!b||(i.setSize(E,b,!1),o.aspect=E/b,o.updateProjectionMatrix(),_())}function S(){g.moved(),_()}return a.addEventListener("change",S),new ResizeObserver(P).observe(n),n.addEventListener("keydown",E=>db(E,o,a)),P(),d(),{renderer:i,scene:s,camera:o,controls:a,size:r,draw:m,redraw:_,moved:S,look:d,frame:y,before:f,ground:u,drawn:()=>p}}function db(n,e,t){let i=new G().crossVectors(e.position,e.up).normalize(),s={ArrowLeft:[e.up,-sh],ArrowRight:[e.up,sh],ArrowUp:[i,-sh],ArrowDown:[i,sh]},r={"+":.9,"=":.9,"-":1/.9}[n.key],o=e.position.clone().sub(t.target);if(s[n.key])o.applyQuaternion(new an().setFromAxisAngle(...s[n.key]));else if(r)o.multiplyScalar(r);else return;n.preventDefault(),e.position.copy(t.target).add(o),t.update()}var gn={silicone:15521453,core:9086404,board:1733432,chip:2500134,north:13379876,south:2708152,cut:13208155,mould:11060382};function vs(n,e){let t=new pn;return t.setAttribute("position",new Ln(Kn(n[`${e}_mm`]),3)),t.setAttribute("normal",new Ln(Kn(n[`${e}_normals`]),3)),t.setIndex(new Ln(n[`${e}_triangles`].data,1)),t}function rh(n,e,t,i=gn.cut){e.clippingPlanes=t;let s=new Os({color:i,side:Un,clippingPlanes:t}),r=new Xt,o=new Et(n,e),a=new Et(n,s);return r.add(o,a),{group:r,front:o,back:a}}function Ra(n,e){let t=new mi({color:3159871,clippingPlanes:e});return new ps(new or(n,35),t)}function Am(n,e){let[t,i,s,r,o,a,l,c,u]=n;return new wt().set(t,i,s,e[0],r,o,a,e[1],l,c,u,e[2],0,0,0,1)}function Tm(n,e,t){let i=[];if(!n[`${e}_mm`])return i;let s=new mn({color:t});for(let r=0;r<n[`${e}_mm`].shape[0];r++){let o=fn(n[`${e}_half_mm`],r,3),a=new Et(new Ai(...o.map(l=>2*l)),s);Cm(a,Am(fn(n[`${e}_axes`],r,9),fn(n[`${e}_mm`],r,3))),i.push(a)}return i}function Cm(n,e){e.decompose(n.position,n.quaternion,n.scale),n.userData.rest={position:n.position.clone(),quaternion:n.quaternion.clone()}}function pb(n){let e=vs(n,"magnet_half"),t=e.clone().rotateX(Math.PI),[i,s]=["north","south"].map(r=>new mn({color:gn[r]}));return Array.from({length:n.magnet_mm.shape[0]},(r,o)=>{let a=new Xt;return a.add(new Et(e,i),new Et(t,s)),Cm(a,Am(fn(n.magnet_axes,o,9),fn(n.magnet_mm,o,3))),a})}function oh({content:n,arrays:e},t){let i=new Xt,s=t.size,r=new G(...n.away),o=n.size_mm.reduce((C,D,F)=>C+D*Math.abs(n.away[F]),0),a=Object.fromEntries(n.faces.map(C=>[C.number,new G(...C.normal)])),l=new In(new G(0,1,0),0),c=[],u=new mn({color:gn.silicone,transparent:!0}),f=rh(vs(e,"silicone"),u,c);f.front.renderOrder=2;let h=rh(vs(e,"core"),new mn({color:gn.core}),c,6258339);h.group.add(Ra(h.front.geometry,c));let p=pb(e),m=Tm(e,"boards",gn.board),_=Tm(e,"chips",gn.chip);i.add(f.group,h.group,...p,...m,..._);let g=n.faces.map(C=>{let D=dr(String(C.number),s/8),F=a[C.number];return D.position.set(...C.centre_mm).addScaledVector(F,s*.09),D.userData={normal:F,rest:D.position.clone()},i.add(D),D});t.before.push(C=>{for(let D of g){let F=C.position.clone().sub(D.position);D.visible=i.visible&&F.dot(D.userData.normal)>0}});let d=Array.from(e.sensor_face.data),y=Array.from(e.magnet_face.data),P=n.magnets_in_shell?p:m,S=n.magnets_in_shell?[...m,..._]:p,E=C=>{let D=p.includes(C)?y[p.indexOf(C)]:d[(m.includes(C)?m:_).indexOf(C)];return a[D]},b=0;function x(C){b=C;let D=r.clone().multiplyScalar(.95*o*C);f.group.position.copy(D),g.forEach(F=>F.position.copy(F.userData.rest).add(D).addScaledVector(F.userData.normal,.2*s*C));for(let F of P)F.position.copy(M(F)).add(D).addScaledVector(E(F),.2*s*C);for(let F of S)F.position.copy(M(F)).addScaledVector(E(F),.16*s*C);t.redraw()}let M=C=>C.userData.moved??C.userData.rest.position;function N(C,D){c.length=0,C&&(l.normal.set(0,0,0).setComponent("xyz".indexOf(C),C==="y"?1:-1),l.constant=D*n.size_mm["xyz".indexOf(C)]/2,c.push(l)),[f,h].forEach(F=>F.back.visible=c.length>0),[f,h].forEach(F=>F.group.traverse(I=>I.material&&(I.material.needsUpdate=!0))),t.redraw()}function A(C){u.opacity=C,u.depthWrite=C>.95,t.redraw()}return N("",0),{root:i,silicone:f,core:h,faces:g,movers:P,explode:x,clip:N,fade:A,offset:()=>f.group.position,again:()=>x(b)}}function Rm({content:n,arrays:e},t){let i=new Xt,s=[11060382,9745290,12760022,14272928],r=n.mould.map((l,c)=>{let u=l.name==="cast shell",f=new mn({color:u?gn.silicone:l.name.startsWith("core")?gn.core:s[c%s.length],side:gi,transparent:!u,opacity:u?1:.9}),h=new Et(vs(e,`mould_${c}`),f);return h.add(Ra(h.geometry,[])),i.add(h),{...l,mesh:h,pull:new G(...l.pull_mm)}});function o(l){for(let{mesh:c,pull:u,begins:f,ends:h}of r){let p=Math.min(1,Math.max(0,(l-f)/(h-f)));c.position.copy(u).multiplyScalar(p)}t.redraw()}function a(){let l=new qi;for(let{mesh:c,pull:u}of r)c.geometry.computeBoundingBox(),l.union(c.geometry.boundingBox).union(c.geometry.boundingBox.clone().translate(u));return l.getBoundingSphere(new ds)}return o(0),i.visible=!1,{root:i,open:o,pieces:r,bounds:a}}var mb=2500;function Im(n,{content:e,arrays:t}){let i=d=>n.querySelector(`[data-name="${d}"]`);n.hidden=!1;let s=Ys(i("canvas"),e.size_mm),[r]=e.layouts,o=!t.body_mm,a=[["body",gn.silicone,.18],["core",gn.core,.4]].filter(([d])=>o||t[`${d}_mm`]).map(([d,...y])=>({name:d,..._b(o?new Ai(2,2,2):vs(t,d),...y,s)})),l=Ss(s,()=>_f()),c=Ss(s,()=>Pa(gn.chip)),u=Ss(s,()=>Pa(gn.board)),f=new ps(new pn,new mi({color:14162842,depthTest:!1,transparent:!0}));f.renderOrder=4,s.scene.add(f),e.faces.forEach(d=>xf(d,s));let h={shown:Math.min(1,e.layouts.length-1),share:1},p=i("front")&&Mm(i("front"),e,d=>g(d,1));function m(){let d=e.layouts[h.shown],y=h.share;a.forEach(S=>S.place(gf(r[S.name],d[S.name],y))),l.place(mf(r.magnets,d.magnets,d.magnet_from,y)),c.place(mf(r.chips,d.chips,d.sensor_from,y)),u.place(mf(r.boards,d.boards,d.sensor_from,y));let P=d.magnets.flatMap((S,E)=>d.magnet_from[E]<0?[]:[...r.magnets[d.magnet_from[E]].at,...S.at]);f.geometry.setAttribute("position",new Ft(P,3)),f.geometry.computeBoundingSphere(),s.redraw()}function _(){let d=e.layouts[h.shown];i("scores").replaceChildren(...e.objectives.map((y,P)=>{let S=document.createElement("tr");return[y,Zt(r.scores[P]),Zt(d.scores[P])].forEach(E=>S.insertCell().append(E)),S})),i("after").textContent=d.label,i("share").setAttribute("aria-valuetext",`${Math.round(100*h.share)} % of the way to ${d.label}`),p?.mark(h.shown)}function g(d,y){Object.assign(h,{shown:d,share:y}),i("layout").value=String(d),i("share").value=String(100*y),_(),m()}return i("layout").append(...e.layouts.slice(1).map((d,y)=>new Option(d.label,y+1))),i("layout").addEventListener("change",()=>g(Number(i("layout").value),h.share)),i("share").addEventListener("input",()=>g(h.shown,Number(i("share").value)/100)),i("opacity").addEventListener("input",()=>a.forEach(d=>d.fade(Number(i("opacity").value)/100))),i("home").addEventListener("click",()=>s.look(4.3)),i("play").addEventListener("click",()=>gb(d=>g(h.shown,d))),g(h.shown,1),{host:n,view:s}}function gb(n){let e=performance.now(),t=matchMedia("(prefers-reduced-motion: reduce)").matches;function i(s){let r=t?1:Math.min(1,Math.max(0,(s-e)/mb));n(r),r<1&&requestAnimationFrame(i)}requestAnimationFrame(i)}var Pm=(n,e,t)=>n.map((i,s)=>i+t*(e[s]-i));function ah(n){let[e,t,i,s,r,o,a,l,c]=n;return new an().setFromRotationMatrix(new wt().set(e,t,i,0,s,r,o,0,a,l,c,0,0,0,0,1))}function gf(n,e,t){let i=ah(n.axes).slerp(ah(e.axes),t);return{at:Pm(n.at,e.at,t),turn:i,half:Pm(n.half,e.half,t)}}function mf(n,e,t,i){let s=(o,a)=>({...o,half:o.half.map(l=>l*a)}),r=n.filter((o,a)=>!t.includes(a));return[...e.map((o,a)=>gf(t[a]<0?s(o,0):n[t[a]],o,i)),...r.map(o=>gf(o,s(o,0),i))]}function Ss(n,e){let t=[];function i(s){for(;t.length<s.length;)t.push(e()),n.scene.add(t.at(-1));t.forEach((r,o)=>{r.visible=o<s.length&&Math.min(...s[o].half)>1e-4,r.visible&&(r.position.set(...s[o].at),r.quaternion.copy(s[o].turn),r.scale.set(...s[o].half))})}return{place:i}}var Pa=n=>new Et(new Ai(2,2,2),new mn({color:n}));function _f(){let n=new Xt;for(let[e,t]of[[gn.north,.5],[gn.south,-.5]]){let i=new Et(new $i(1,1,1,32),new mn({color:e}));i.rotation.x=Math.PI/2,i.position.z=t,n.add(i)}return n}function _b(n,e,t,i){let s=new mn({color:e,transparent:!0,opacity:t,depthWrite:!1}),r=new Et(n,s);r.add(new ps(new or(n,35),new mi({color:3159871})));let o=Ss(i,()=>r);return{place:l=>o.place([l]),fade:l=>{s.opacity=t*2*l,i.redraw()}}}function xf(n,e){let t=dr(String(n.number),e.size/8);t.position.set(...n.centre_mm).addScaledVector(new G(...n.normal),e.size*.09),e.scene.add(t),e.before.push(i=>t.visible=go(n,i))}var xb=["map","explode","opacity","clip-axis","clip","opening"];function Nm(n){let e=!1,t=(s,r)=>{if(!e){e=!0;try{n.filter(o=>o!==s).forEach(r)}finally{e=!1}}};vb(n);for(let s of n){s.watchers.push(()=>t(s,r=>Lm(s,r))),s.view.controls.addEventListener("change",()=>t(s,r=>Dm(s,r)));for(let r of["input","change"])s.host.addEventListener(r,o=>t(s,a=>yb(o,a)));s.find("open").addEventListener("click",()=>t(s,r=>r.find("open").click()))}let i=n.reduce((s,r)=>s.view.size>=r.view.size?s:r);t(i,s=>Dm(i,s)),t(n[0],s=>Lm(n[0],s))}function Lm(n,e){let{face:t,place:i,step:s}=n.press.state,r=n.content.faces[t].number,o=e.content.faces.findIndex(f=>f.number===r);if(o<0)return;let[a,l]=n.press.xy(i),c=s?n.press.depths[s-1]:0,u=[0,...e.press.depths].map(f=>Math.abs(f-c));e.choose(o,e.near(o,a,l),u.indexOf(Math.min(...u)))}function Dm(n,e){e.view.controls.target.copy(n.view.controls.target),e.view.camera.position.copy(n.view.camera.position),e.view.controls.update(),e.view.redraw()}function yb(n,e){let{name:t}=n.target.dataset;if(n.target.type==="radio"){let i=e.host.querySelector(`[type=radio][value="${n.target.value}"]`);if(i.closest("label").hidden)return;i.checked=!0,i.dispatchEvent(new Event(n.type))}else xb.includes(t)&&(e.find(t).value=n.target.value,e.find(t).dispatchEvent(new Event(n.type)))}function vb(n){for(let{stem:e}of n[0].content.maps){let t=n.map(r=>r.content.maps.find(o=>o.stem===e)),i=n.map((r,o)=>r.maps.endsOf(t[o])),s=[Math.min(...i.map(([r])=>r)),Math.max(...i.map(([,r])=>r))];n.forEach(r=>r.maps.fix(e,s))}}var lh=Math.sqrt(-2*Math.log(.05)),Um=64,Sb=.15,[Mb,bb]=[16777215,1.06],Fm=[1,2,5,10,20,50,100];function wb(n){let e=new ro(new pn,new mi({color:n,depthTest:!1,transparent:!0}));return e.renderOrder=6,e}function Ia(n,e,t){if(n===null)return{most:NaN,least:NaN,turn:0};let[i,s]=[(n+t)/2,Math.hypot((n-t)/2,e)];return{most:Math.sqrt(i+s),least:Math.sqrt(Math.max(0,i-s)),turn:Math.atan2(2*e,n-t)/2}}function ch({content:n,arrays:e},t,i,s,r){let o=new Xt;o.add(...[Mb,r].map(wb)),o.visible=!1;let a=new gs,l=e.place_xy_mm.shape[0],c=Eb(n,e,i,s.size),u=null;function f(m,_){let{most:g}=i(m,_);o.visible=Number.isFinite(g);let d=`${m} ${_}`;if(!o.visible||u===d&&n.faces[m].flat)return;u=d;let y=new G(...fn(e.place_mm,m*l+_,3)),[P,S,E]=["x","y","normal"].map(b=>new G(...n.faces[m][b]));t.silicone.front.updateWorldMatrix(!0,!1),o.children.forEach((b,x)=>{let M=c*(x?1:bb),N=h(m,_,y,[P,S,E],M);b.geometry.setAttribute("position",new Ft(N,3)),b.geometry.computeBoundingSphere()})}function h(m,_,g,[d,y,P],S){let{most:E,least:b,turn:x}=i(m,_),M=[],N=fn(e.place_xy_mm,_,2),A=ff(n.faces[m],N);for(let C=0;C<=Um;C++){let D=2*Math.PI*C/Um,[F,I]=[S*lh*E*Math.cos(D),S*lh*b*Math.sin(D)],z=[N[0]+F*Math.cos(x)-I*Math.sin(x),N[1]+F*Math.sin(x)+I*Math.cos(x)],X=ff(n.faces[m],z),B=g.clone().addScaledVector(d,X[0]-A[0]).addScaledVector(y,X[1]-A[1]),he=n.faces[m].flat?B:p(B,P,2*S*lh*E+1);he&&M.push(...he.addScaledVector(P,Sb).toArray())}return M}function p(m,_,g){a.set(m.clone().addScaledVector(_,g).add(t.offset()),_.clone().negate()),a.far=2*g;let[d]=a.intersectObject(t.silicone.front,!1);return d?d.point.sub(t.offset()):null}return{line:o,scale:c,draw:f,hide:()=>o.visible=!1}}function Eb({faces:n},{place_xy_mm:e},t,i){let s=e.shape[0],r=n.flatMap((a,l)=>Array.from({length:s},(c,u)=>lh*t(l,u).most)).filter(Number.isFinite).sort((a,l)=>a-l),o=r[Math.floor(r.length/2)]??i;return Fm.find(a=>a*o>=i/45)??Fm.at(-1)}function Om(n,e,t){let{content:i,arrays:s}=n,{depth_mm:r,shown_steps:o}=i.press,[,a,l]=s.force_n.shape,c=s.sensor_mm.shape[0],u=e.silicone.front.geometry,f=Kn(s.silicone_mm),h=Kn(s.link_mm),p=new Float32Array(s.shape.shape[2]),m=Tb(i.tip,t.size),_=Array.from({length:c},()=>ih(14162842,t.size/130,!0)),[g,d]=[14162842,1842204].map(Q=>ch(n,e,B,t,Q)),y=new Xt,P=new Xt;P.add(..._.map(Q=>Q.object)),y.add(m,g.line,d.line),t.scene.add(y,P);let S=Array.from({length:c},(Q,ie)=>new G(...fn(s.sensor_mm,ie,3))),E=Array.from({length:c},(Q,ie)=>fn(s.sensor_axes,ie,9)),b={face:0,place:0,step:0},x=Q=>Q?s.force_n.data[(b.face*a+b.place)*l+Q-1]:0,M=()=>b.face*a+b.place;function N(Q){let ie=x(Q);if(!Q||!ie)return[];let Z=r[Q-1],de=o.length-1,se=o.findIndex(ne=>r[ne]>=Z);se=se<0?de:se;let ge=Math.max(0,se-1),me=se===ge?1:Math.max(0,(Z-r[o[ge]])/(r[o[se]]-r[o[ge]]));return(se===ge?[[se,1]]:[[ge,1-me],[se,me]]).filter(([,ne])=>ne>0).map(([ne,le])=>[ne,le*ie/(x(o[ne]+1)||ie)])}function A(Q){p.fill(0);let{data:ie,shape:Z,step:de}=s.shape,[,se,ge]=Z;for(let[W,ne]of Q){let le=ne*de*r[o[W]],De=(b.face*se+W)*ge;for(let Oe=0;Oe<ge;Oe++)p[Oe]+=le*ie[(De+Oe)*a+b.place]}let me=u.attributes.position;me.array.set(f),s.link_vertex.data.forEach((W,ne)=>{let le=p[s.link_source.data[ne]];for(let De=0;De<3;De++)me.array[3*W+De]+=le*h[3*ne+De]}),Q.length&&C(me.array),me.needsUpdate=!0,u.computeVertexNormals(),u.computeBoundingSphere()}function C(Q){let ie=i.tip.radius_mm;if(!ie)return;let{origin:Z,axes:de}=D(),se=Z.clone().addScaledVector(de[2],ie-r[b.step-1]),ge=new G;for(let me=0;me<Q.length;me+=3){if(ge.set(Q[me]-se.x,Q[me+1]-se.y,Q[me+2]-se.z),ge.lengthSq()>=ie*ie)continue;let W=ge.dot(de[2]),ne=-Math.sqrt(ie*ie-ge.lengthSq()+W*W)-W;Q[me]+=ne*de[2].x,Q[me+1]+=ne*de[2].y,Q[me+2]+=ne*de[2].z}}function D(){let Q=fn(s.place_axes,M(),9),ie=[0,1,2].map(Z=>new G(Q[Z],Q[3+Z],Q[6+Z]).normalize());return{origin:new G(...fn(s.place_mm,M(),3)),axes:ie}}function F(Q){e.movers.forEach((ie,Z)=>{let de=new G,se=new G;for(let[le,De]of Q){let Oe=(M()*o.length+le)*e.movers.length+Z;de.addScaledVector(new G(...fn(s.motion_mm,Oe,3)),De),se.addScaledVector(new G(...fn(s.motion_rad,Oe,3)),De)}let{position:ge,quaternion:me}=ie.userData.rest;ie.userData.moved=ge.clone().add(de);let W=se.length(),ne=new an().setFromAxisAngle(W?se.clone().divideScalar(W):new G(0,0,1),W);ie.quaternion.copy(ne.multiply(me))}),e.again()}function I(Q){return b.step?fn(s.counts,(M()*l+b.step-1)*c+Q,3):[0,0,0]}function z(){let Q=i.press.noise_counts,ie=s.live.data;return S.map((Z,de)=>({sensor:de,face:s.sensor_face.data[de],counts:I(de),noise:Q,live:[0,1,2].map(se=>ie[3*de+se]>0)}))}function X(){let Q=Math.log1p(32e3/Math.min(...i.press.noise_counts));z().forEach(({counts:ie,noise:Z,live:de},se)=>{let ge=new G,me=0;ie.forEach((ne,le)=>{de[le]&&(ge.addScaledVector(new G(...E[se].slice(3*le,3*le+3)),ne),me+=(ne/Z[le])**2)});let W=ge.length()?.75*t.size*Math.log1p(Math.sqrt(me))/Q:0;_[se].point(S[se],ge.normalize(),me>1?W:0)})}function B(Q,ie){return Ia(...fn(s.ellipse_mm2,Q*a+ie,3))}function he(Q,ie,Z){Object.assign(b,{face:Q,place:ie,step:Z});let de=N(Z);A(de),F(de),X(),g.draw(Q,ie),d.hide();let{origin:se,axes:ge}=D();m.position.copy(se).addScaledVector(ge[2],-(Z?r[Z-1]:0)),m.quaternion.setFromUnitVectors(new G(0,0,1),ge[2]),Y()}function Y(){y.position.copy(e.offset()),y.visible=e.root.visible,P.visible=e.root.visible&&e.offset().lengthSq()<1e-6,t.redraw()}function ee(Q){Q?d.draw(Q.face,Q.place):d.hide(),t.redraw()}return{state:b,set:he,hover:ee,xy:Q=>Array.from(s.place_xy_mm.data.subarray(2*Q,2*Q+2)),ringScale:g.scale,signals:z,circle:B,force:()=>x(b.step),depths:r,group:y,places:a,follow:Y}}function Tb({radius_mm:n},e){let t=new mn({color:7171445,transparent:!0,opacity:.55}),i=new Xt,s=n??e/20;if(n){let o=new Et(new ar(s,40,20),t);o.position.z=s,i.add(o)}let r=new Et(new $i(s*.45,n?s*.45:.1,e/3,24),t);return r.rotation.x=Math.PI/2,r.position.z=(n?s:0)+e/6,i.add(r),i.traverse(o=>o.renderOrder=3),i}var Ab=5,Cb=3e3,Bm=0;function zm(n,e){let t=_=>n.querySelector(`[data-name="${_}"]`),{content:i}=e;n.hidden=!1,n.querySelectorAll("[type=radio]").forEach(_=>{_.name=`scene-${Bm}`,_.checked=_.value==="object"}),Bm+=1;let s=Ys(t("canvas"),i.size_mm),r=oh(e,s),o=Rm(e,s);s.scene.add(r.root,o.root);let a=Jc(e,r,s),l=Om(e,r,s),c=Rb(l.signals()),u=[];function f(){let{face:_,place:g,step:d}=l.state,{x_mm:y,y_mm:P}=i.grid,S=P.length,E=d?l.depths[d-1]:0,b=d?i.press.force_error[d-1]:null,{most:x,least:M}=l.circle(_,g);t("place").textContent=`face ${i.faces[_].number} (${y[Math.floor(g/S)]}, ${P[g%S]}) mm`,t("travel").textContent=`${E.toFixed(2)} mm`,t("force").textContent=`${l.force().toFixed(2)} N`,t("error").textContent=b===null?"":`\xB1 ${(100*b).toFixed(1)} % by the mesh (rms)`,t("bound").textContent=`${Zt(x)} \xD7 ${Zt(M)} mm`,t("ring").textContent=l.ringScale>1?`rings drawn ${l.ringScale} times as large`:"",t("score").textContent=a.shown()?`${Zt(a.valueAt(_,g))} ${a.shown().unit}`:"\u2013";let N=l.signals().map(A=>({...A,number:c[A.sensor]}));ym(t("bars"),N),vm(t("counts"),N),t("depth").setAttribute("aria-valuetext",`${E} mm deep`)}function h(_,g,d){l.set(_,g,d),t("face").value=String(_),t("x").value=String(Math.floor(g/i.grid.y_mm.length)),t("y").value=String(g%i.grid.y_mm.length),t("depth").value=String(d),f(),u.forEach(y=>y(l.state))}Pb(t,i,l),Ib(t,{scene:e,object:r,mould:o,maps:a,press:l,choose:h,tell:f,view:s,content:i}),Nb(t,{scene:e,view:s,object:r,maps:a,press:l,choose:h});let p=hh(l,e,0,0,0);return h(0,p,Math.ceil(l.depths.length/2)),r.fade(Number(t("opacity").value)/100),{host:n,find:t,content:i,view:s,maps:a,press:l,choose:h,near:(_,g,d)=>hh(l,e,_,g,d),watchers:u}}function Rb(n){let e={};return n.map(({face:t})=>e[t]=(e[t]??0)+1)}function Pb(n,e,t){let i=(s,r)=>new Option(r,s);n("face").append(...e.faces.map((s,r)=>i(r,s.number))),n("x").append(...e.grid.x_mm.map((s,r)=>i(r,`${s} mm`))),n("y").append(...e.grid.y_mm.map((s,r)=>i(r,`${s} mm`))),n("map").append(...e.maps.map(({stem:s,title:r})=>i(s,r))),n("depth").max=String(t.depths.length),n("mould-choice").hidden=!e.mould.length}function Ib(n,{scene:e,object:t,mould:i,maps:s,press:r,choose:o,tell:a,view:l,content:c}){let u=(m,_,g)=>n(m).addEventListener(_,g),f=m=>Number(n(m).value);u("explode","input",()=>{t.explode(f("explode")/100),r.follow(),l.look(4.3+f("explode")/45,f("explode")/220,!0)}),u("opacity","input",()=>t.fade(f("opacity")/100));let h=()=>t.clip(n("clip-axis").value,f("clip")/100);u("clip-axis","change",h),u("clip","input",h),u("map","change",()=>{let m=s.show(n("map").value);Kc(n("legend"),m),m&&(n("opacity").value="100"),t.fade(f("opacity")/100),a()});for(let m of["face","x","y"])u(m,"change",()=>{let[_,g]=[c.grid.x_mm[f("x")],c.grid.y_mm[f("y")]];o(f("face"),hh(r,e,f("face"),_,g),r.state.step)});u("depth","input",()=>o(r.state.face,r.state.place,f("depth")));let p=()=>i.root.visible?l.frame(i.bounds()):l.look(4.3);u("home","click",p);for(let m of n("scenes").querySelectorAll("input"))m.addEventListener("change",()=>{let _=n("scenes").querySelector("input:checked").value;t.root.visible=_==="object",i.root.visible=_==="mould",n("object-controls").hidden=_!=="object",n("mould-controls").hidden=_!=="mould",l.ground.visible=_==="object",r.follow(),p()});u("opening","input",()=>i.open(f("opening")/100)),u("open","click",()=>Lb(n,i))}function Lb(n,e){let t=performance.now(),i=matchMedia("(prefers-reduced-motion: reduce)").matches;function s(r){let o=i?1:Math.min(1,(r-t)/Cb);n("opening").value=String(100*o),e.open(o),o<1&&requestAnimationFrame(s)}requestAnimationFrame(s)}function hh(n,{arrays:e},t,i,s){let[r,o]=[0,1/0],{data:a}=e.place_xy_mm;for(let l=0;l<n.places;l++){let c=Math.hypot(a[2*l]-i,a[2*l+1]-s);c<o&&Number.isFinite(e.force_n.data[(t*n.places+l)*n.depths.length])&&([r,o]=[l,c])}return r}function Db({x_mm:n,y_mm:e},t,i){return[n,e].every((s,r)=>Math.abs(t[r]-i[r])<=(s.length>1?s[1]-s[0]:1)/2+.001)}function Nb(n,{scene:e,view:t,object:i,maps:s,press:r,choose:o}){let a=n("canvas"),l=new gs,{content:c}=e,u=i.silicone.front;function f(p){if(!i.root.visible)return null;let m=a.getBoundingClientRect(),_=new Ye((p.clientX-m.left)/m.width*2-1,1-(p.clientY-m.top)/m.height*2);l.setFromCamera(_,t.camera);let g=l.intersectObject(u,!1).find(({point:x})=>u.material.clippingPlanes.every(M=>M.distanceToPoint(x)>=0));if(!g)return null;let d=[g.face.a,g.face.b,g.face.c],y=Math.max(...d.map(x=>s.owner[x]));if(y<0)return null;let P=g.point.clone().sub(i.offset()),[S,E]=Ca(c.faces[y],P.x,P.y,P.z),b=hh(r,e,y,S,E);return{face:y,x:S,y:E,place:b,judged:Db(c.grid,r.xy(b),[S,E])}}let h=null;a.addEventListener("pointerdown",p=>h=[p.clientX,p.clientY]),a.addEventListener("pointerup",p=>{let m=h&&Math.hypot(p.clientX-h[0],p.clientY-h[1])<Ab;h=null;let _=m&&f(p);_&&o(_.face,_.place,r.state.step||r.depths.length)}),a.addEventListener("pointerleave",()=>{r.hover(null),n("under").textContent=""}),a.addEventListener("pointermove",p=>{if(p.buttons)return;let m=f(p);if(r.hover(m?.judged?m:null),!m)return void(n("under").textContent="");let _=`face ${c.faces[m.face].number} (${m.x.toFixed(1)}, ${m.y.toFixed(1)}) mm`;if(!m.judged)return void(n("under").textContent=`${_}: not judged`);let{most:g,least:d}=r.circle(m.face,m.place),y=s.shown()?`${s.shown().title} ${Zt(s.valueAt(m.face,m.place))} ${s.shown().unit}; `:"";n("under").textContent=`${_}: ${y}\u03C3 ${Zt(g)} \xD7 ${Zt(d)} mm`})}var[yf,km]=[14162842,16777215];function Vm({scene:n,body:e,parts:t,maps:i,view:s,find:r}){let{content:o,arrays:a}=n,l=a.place_xy_mm.shape[0],c=Kn(a.silicone_normals),u=Kn(a.silicone_mm),f=[],h=(E,b)=>f.find(x=>x.face===E&&x.place===b)?.circle??Ia(null),p=[0,1].map(()=>ch(n,e,h,s,yf)),[m,..._]=[km,yf,yf].map(E=>{let b=new Et(new ar(s.size/(E===km?45:60),24,16),new mn({color:E,depthTest:!1,transparent:!0,opacity:.9}));return b.renderOrder=7,b.visible=!1,b});s.scene.add(...p.map(E=>E.line),m,..._);let g=(E,b,x)=>{E.position.fromArray(a.place_mm.data,3*(b*l+x)),E.userData.face=o.faces[b]};s.before.push(E=>[m,..._].forEach(b=>b.visible=!!b.userData.face&&go(b.userData.face,E)));function d({face:E,place:b},x){let M=new G(...fn(a.place_mm,E*l+b,3)),[N,A]=[1/0,-1];i.owner.forEach((D,F)=>{if(D!==E)return;let I=Math.hypot(u[3*F]-M.x,u[3*F+1]-M.y,u[3*F+2]-M.z);I<N&&([N,A]=[I,F])});let C=A<0?o.faces[E].normal:c.subarray(3*A,3*A+3);return{origin:M,normal:new G(...C),profile:x}}function y(E,{counts:b,noise_counts:x,position_mm2:M,motions:N,skin_mm:A},C,D){f=E.map((F,I)=>({...F,circle:Ia(M[I][0],M[I][1],M[I][3])})),e.bend(f.map(F=>d(F,A))),t.move({face:E[0].face,motions:N}),p.forEach((F,I)=>{F.hide(),F.draw(0,NaN),f[I]&&F.draw(f[I].face,f[I].place)}),_.forEach((F,I)=>f[I]?g(F,f[I].face,f[I].place):F.userData.face=null),P(C,b,x,D),s.redraw()}function P(E,b,x,M){let N=f.map(({circle:{most:C,least:D}},F)=>`(${E[F].map(I=>I.toFixed(1)).join(", ")}) mm to ${Zt(C)} \xD7 ${Zt(D)} mm`),A=f.length>1?"Both presses are read from the same chips at once. ":"";r("pressed").textContent=`${M} N on face ${o.faces[f[0].face].number}: the place is told at ${N.join(" and at ")} (one standard deviation); a ring holds 95 of 100 readings. ${A}The skin is drawn as that of a flat layer. Change of this face's chips in counts, with one standard deviation of noise; bold stands out of it:`,r("press-head").hidden=!1,r("counts").replaceChildren(...Array.from({length:b.length/3},(C,D)=>{let F=document.createElement("tr");return F.append(Object.assign(document.createElement("th"),{textContent:`${D+1}`})),b.slice(3*D,3*D+3).forEach((I,z)=>{let X=F.insertCell();X.textContent=I===null?"\u2013":`${I.toFixed(0).replace("-","\u2212")} \xB1 ${x[z].toFixed(0)}`,X.style.fontWeight=Math.abs(I)>3*x[z]?"700":""}),F}))}function S(){f=[],e.bend([]),t.move(null),p.forEach(E=>E.hide()),_.forEach(E=>E.userData.face=null),r("pressed").textContent="No press.",r("press-head").hidden=!0,r("counts").replaceChildren(),s.redraw()}return{show:y,release:S,markWorst:(E,b)=>g(m,E,b)}}var Ub=1e3,uh=(n,e)=>Object.assign(document.createElement(n),e);function Gm({find:n,ask:e,frozen:t,now:i,renew:s,take:r}){let[o,a,l]=[!1,!1,null],c="";async function u(){if(a=!0,!(t||o)){o=!0;try{for(;;){a=!1;let m=await e("state",{design:i().design});if(f(m),m.scene!==i().scene&&s(),!m.work.running&&l&&await h(),!m.refining&&!m.work.running&&!a)break;await new Promise(_=>setTimeout(_,Ub))}}catch(m){n("trouble").textContent=m.message}o=!1}}function f({refined:m,work:_}){n("refined").textContent=m,n("improve").disabled=n("confirm").disabled=_.running,n("stop").disabled=!_.running,n("work-command").textContent=_.command,n("work-line").textContent=_.command&&`${_.running?"at work":_.failed?"ended early":"finished"}${_.line?`: ${_.line}`:""}`;let g=JSON.stringify(_.layouts);g!==c&&(c=g,n("layouts").replaceChildren(..._.layouts.map(({label:d,design:y})=>{let P=uh("li",{textContent:`${d} `});return P.append(uh("button",{type:"button",textContent:"take",onclick:()=>r(y)})),P})))}async function h(){let{rows:m,channels:_}=await e("confirmed",l);l=null;let g=({page:d,chain:y})=>d===null||y===null?"\u2013":Zt(y/d);n("confirmed").replaceChildren(...m.map(d=>{let y=uh("tr",{});return y.append(uh("th",{textContent:d.name})),[d.page,d.chain].forEach(P=>y.insertCell().append(P===null?"\u221E":Zt(P))),y.insertCell().append(g(d)),y})),n("confirmed-head").hidden=!m.length,n("confirmed-note").textContent=m.length&&_==="all"?"The chain reads the chips of all faces, the page those of the pressed face: part of the difference.":""}async function p(m,_){try{let{design:g,force:d}=i();await e(m,{design:g,force_n:d,..._}),n("trouble").textContent="",m==="confirm"&&(l={design:g,force_n:d}),await u()}catch(g){n("trouble").textContent=g.message}}return n("improve").addEventListener("click",()=>p("improve",{seconds:Number(n("seconds").value)})),n("confirm").addEventListener("click",()=>p("confirm",{})),n("stop").addEventListener("click",()=>p("stop",{})),{watch:u}}var Hm={position:["Error of the place, one standard deviation","mm"],force:["Error of the force, one standard deviation","N"],least:["Least force that is felt","N"]},Wm=.1,Xm=.95,Fb=14687012,Ob=[.5,2],qm=["size-x","size-y","size-z"],Bb=4,zb=300,kb=1e9,$s=n=>JSON.parse(JSON.stringify(n)),La=(n,e)=>Object.assign(document.createElement(n),e),Ym=(n,e)=>n.textContent!==e&&(n.textContent=e),Jm=n=>Math.round(n/Wm)/(1/Wm);async function Vb(n,e){let t={method:"POST",body:JSON.stringify(e),headers:{"Content-Type":"application/json"}},i=await fetch(`/${n}`,t).catch(()=>{throw new Error("The server does not answer. Start instobj explore again on the same port: this page keeps the design.")}),s=await i.json();if(!i.ok)throw new Error(s.error??i.statusText);return s}function Gb(n){let e=JSON.parse(n.textContent);return async(t,{figure:i,force_n:s,face:r,places:o})=>t==="limits"||t==="range"?e[t]:t==="judge"?e[`judge ${i} ${s}`]:e[`press ${r} ${s}`][o[0]]}async function $m(n){let e=document.getElementById("scene");if(e)return tr(Wa(e.textContent));let t=await fetch("/scene",n&&{method:"POST",body:JSON.stringify({design:n}),headers:{"Content-Type":"application/json"}});return tr(new Uint8Array(await t.arrayBuffer()))}async function Hb(){let n=W=>document.querySelector(`[data-name="${W}"]`),e=await $m(),{content:t,arrays:i}=e,s=document.getElementById("answers"),r=s?Gb(s):Vb;document.body.classList.toggle("frozen",!!s),n("name").textContent=s?`${t.name}, to look at and press`:`${t.name}, explored`,s&&(n("hint").textContent="drag: turn \xB7 shift and click: press"),t.forces_n.forEach(W=>n("force").append(new Option(`${W} N`,W))),t.ranges_mt.forEach(W=>n("range").append(new Option(`\xB1${W} mT`,W))),t.silicones.forEach(W=>n("silicone").append(new Option(W))),n("of-size").hidden=!t.sizable,n("force").value=String(t.forces_n[Math.floor(t.forces_n.length/2)]);let o=Ys(n("canvas"),t.size_mm),a=new Set(o.scene.children),l={design:$s(t.design),answer:null,broken:[],used:null,pinned:null,chosen:null,presses:[]},c={past:[],future:[]},u=[],f,h,p,m,_;function g(W){e=W,{content:t,arrays:i}=W,o.before.length=0,o.scene.children.filter(ne=>!a.has(ne)).forEach(ne=>{o.scene.remove(ne),ne.traverse(le=>le.geometry?.dispose())}),h=i.place_xy_mm.shape[0],i.map_live={data:new Float32Array(t.faces.length*h).fill(NaN)},t.maps=[{stem:"live",weak:"high",log:!0}],f=$b(e,o),p=Jc(e,f,o),m=Jb(o,t),_=Vm({scene:e,body:f,parts:m,maps:p,view:o,find:n}),l.presses=[],n("accuracy").textContent=t.accuracy,f.fade(Number(n("opacity").value)/100)}g(e);let[d,y,P]=[!1,!1,0],[S,E]=[!1,!1],b=W=>({design:W,figure:n("figure").value,force_n:Number(n("force").value)});async function x(W){if(W&&(P=P||W),d)return void(y=!0);d=!0;let ne=P;P=0;try{l.answer=await M(l.design),n("trouble").textContent="",A(),ne&&requestAnimationFrame(()=>requestAnimationFrame(()=>u.push(performance.now()-ne))),l.presses.length&&await de(l.presses),N(),t.scene.endsWith("full")||ge.watch()}catch(le){n("trouble").textContent=le.message}if(d=!1,y)return y=!1,void x();await r("range",{design:l.design}).then(le=>l.used=le.range_used,()=>l.used=null),C()}async function M(W){let ne=await r("judge",b(W));for(;ne.scene!==t.scene;)g(await $m(W)),ne=await r("judge",b(W));return ne}async function N(){if(S)return void(E=!0);S=!0;do{E=!1;let W=new Promise(ne=>setTimeout(ne,zb));await r("limits",{design:l.design}).catch(({message:ne})=>({broken:[{text:ne,magnets:[],sensors:[],faces:[]}]})).then(F),await W}while(E);S=!1}function A(){let{answer:W,pinned:ne}=l,le=n("difference").checked&&ne?.answer.scene===W.scene,[[De,Oe],Xe]=[Hm[n("figure").value],n("force").value];W.values.forEach((ht,yt)=>{i.map_live.data[yt]=ht===null?i.there.data[yt]?kb:NaN:le?ht/ne.answer.values[yt]:ht}),Object.assign(t.maps[0],le?{title:"Now over pinned; above 1 is worse",unit:"times"}:{title:De,unit:Oe},{force_n:Xe}),p.fix("live",le?Ob:l.ends??=qb(W.values.filter(ht=>ht>0))),Kc(n("legend"),p.show("live")),m.place(W.parts),o.moved(),I(),C(),ie()}function C(){let{answer:W,pinned:ne,used:le}=l,De=n("figure").value,[Oe,Xe]=[W.summary[De],ne?.answer.summary[De]],ht=Hm[De][1],yt=[[`half of the places are below, ${ht}`,Oe.median,Xe?.median],[`95 of 100 places are below, ${ht}`,Oe.percentile_95,Xe?.percentile_95],[`worst place, ${ht}`,Oe.worst,Xe?.worst],["chips' range in use, %",le?100*le:"\u2026",ne?.used?100*ne.used:""],["magnets; chips",`${W.magnets}; ${W.sensors}`,ne?`${ne.answer.magnets}; ${ne.answer.sensors}`:""],["price of both, \u20AC; work by hand, min",W.price_and_minutes.map(Math.round).join("; "),ne?.answer.price_and_minutes.map(Math.round).join("; ")]];n("numbers").rows.length||n("numbers").replaceChildren(...yt.map(([Kt])=>Xb(Kt,["",""]))),yt.forEach(([Kt,...mt],sn)=>[Kt,...mt].forEach((Nt="",jt)=>{Ym(n("numbers").rows[sn].cells[jt],Nt===null?"\u221E":typeof Nt=="number"?Zt(Nt):Nt)}));let[zt,vt]=D(Oe.place);Ym(n("worst"),`The worst place is on face ${t.faces[Oe.face].number} at (${zt.toFixed(1)}, ${vt.toFixed(1)}) mm, at the white ball.`),_.markWorst(Oe.face,Oe.place)}let D=W=>Array.from(i.place_xy_mm.data.subarray(2*W,2*W+2));function F({broken:W}){l.broken=W;let ne=W.length?W.map(Wb):["All limits of instobj check are kept."];l.answer.beyond&&ne.push("A part lies where the quick model knows no motions: it is judged at the nearest place that it knows."),n("limits").replaceChildren(...ne.map(le=>La("li",{textContent:le,className:W.length?"broken":"kept"}))),I(),C()}function I(){m.paint(l.broken,l.chosen,he(l.design)),o.redraw()}function z(){c.past.push($s(l.design)),c.future=[]}function X(W,ne){c[ne].push(l.design),l.design=c[W].pop(),l.chosen=null,x()}let B=W=>{z(),W(l.design),x(performance.now())},he=({magnets:W})=>!Array.isArray(W.positions_mm[0][0]);function Y({magnets:W,sensors:ne},le){return le==="magnet"?he({magnets:W})?[W.positions_mm]:W.positions_mm:ne.positions_mm??=$s(l.answer.shown.sensors_mm)}function ee(W,ne,le){let De=Y(W,ne);return De[De.length===t.faces.length?le:(t.faces[le].number-1)%De.length]}let re=()=>l.design.magnets.depth_mm??=$s(l.answer.shown.depth_mm),Q=({kind:W,face:ne,number:le})=>ee($s(l.design),W,ne)[le];function ie(){n("undo").disabled=!c.past.length,n("redo").disabled=!c.future.length;let{chosen:W,design:ne}=l,le=W?.kind==="magnet";n("of-magnet").hidden=!le||!t.magnets_in_shell,n("of-tilt").hidden=!le||!t.tiltable,n("remove").disabled=!W,n("part").textContent=W?`Part: ${le?"magnet":"chip"} ${W.number+1} of face ${t.faces[W.face].number}`:"Part: none chosen, click one",n("alike").textContent=he(ne)?"A magnet moves alike on every face; a chip on its face alone.":"Magnets and chips move on their face alone; depth, pole and tilt are alike on every face.",["x","y"].forEach((De,Oe)=>Z(De,W&&Q(W)[Oe])),le&&(Z("depth",(ne.magnets.depth_mm??l.answer.shown.depth_mm)[W.number]),["tilt-x","tilt-y"].forEach((De,Oe)=>Z(De,ne.magnets.tilt_deg[W.number][Oe])),n("north").value=ne.magnets.north[W.number]),n("range").value=String(ne.sensors.range_mt),Z("chip-depth",ne.sensors.depth_below_core_face_mm),Z("thickness",ne.shell.thickness_mm),n("silicone").value=ne.silicone.name,qm.forEach((De,Oe)=>Z(De,ne.body.size_mm[Oe]))}function Z(W,ne){let le=n(W);le.disabled=ne==null,document.activeElement!==le&&(le.value=le.disabled?"":String(ne))}async function de(W){if(l.presses=W,n("release").disabled=!W.length,!W.length)return _.release();let ne=Number(n("force").value),[{face:le}]=W,De={design:l.design,face:t.faces[le].number,places:W.map(({place:Xe})=>Xe),force_n:ne},Oe=await r("press",De);l.presses===W&&_.show(W,Oe,W.map(({place:Xe})=>D(Xe)),ne)}let se=(W,ne,le)=>n(W).addEventListener(ne,le),ge=Gm({find:n,ask:r,frozen:!!s,now:()=>({design:l.design,scene:t.scene,force:Number(n("force").value)}),renew:()=>x(),take:W=>B(()=>{l.design=$s(W),l.chosen=null})});async function me(){l.ends=null,l.pinned&&(l.pinned.answer=await r("judge",b(l.pinned.design))),x()}se("figure","change",me),se("force","change",me),se("fit","click",()=>{l.ends=null,A()}),se("difference","change",A),se("opacity","input",()=>f.fade(Number(n("opacity").value)/100)),se("undo","click",()=>X("past","future")),se("redo","click",()=>X("future","past")),document.addEventListener("keydown",({key:W,ctrlKey:ne,metaKey:le,target:De})=>(ne||le)&&!De.matches("input")&&{z:n("undo"),y:n("redo")}[W]?.click()),se("pin","click",()=>{l.pinned=$s({design:l.design,answer:l.answer,used:l.used}),n("difference").disabled=!1,A()}),se("save","click",async()=>{try{let W=await r("save",{design:l.design}),ne=La("p",{className:"note",textContent:W.comments_kept?`Saved in ${W.file}; its comments stayed.`:`Saved in ${W.file}; the comments of the first file could not be kept.`});n("commands").replaceChildren(ne,...W.commands.map(le=>La("code",{textContent:le}))),n("trouble").textContent=""}catch(W){n("trouble").textContent=W.message}}),["x","y"].forEach((W,ne)=>se(W,"change",()=>B(()=>ee(l.design,l.chosen.kind,l.chosen.face)[l.chosen.number][ne]=Number(n(W).value)))),se("depth","change",()=>B(()=>re()[l.chosen.number]=Number(n("depth").value))),["tilt-x","tilt-y"].forEach((W,ne)=>se(W,"change",()=>B(({magnets:le})=>le.tilt_deg[l.chosen.number][ne]=Number(n(W).value)))),se("north","change",()=>B(({magnets:W})=>W.north[l.chosen.number]=n("north").value)),se("range","change",()=>B(({sensors:W})=>W.range_mt=Number(n("range").value))),se("chip-depth","change",()=>B(({sensors:W})=>W.depth_below_core_face_mm=Number(n("chip-depth").value))),se("thickness","change",()=>B(({shell:W})=>W.thickness_mm=Number(n("thickness").value))),se("silicone","change",()=>B(({silicone:W})=>W.name=n("silicone").value)),qm.forEach((W,ne)=>se(W,"change",()=>B(le=>le.body.size_mm[ne]=Number(n(W).value)))),se("release","click",()=>de([]));for(let W of["magnet","sensor"])se(`add-${W}`,"click",()=>B(ne=>{Y(ne,W).forEach(le=>le.push(Yb(le,t.faces[0]))),W==="magnet"&&Zm(ne.magnets,le=>le.push($s(le.at(-1))))}));se("remove","click",()=>B(W=>{let{kind:ne,number:le}=l.chosen;Y(W,ne).forEach(De=>De.splice(le,1)),ne==="magnet"&&Zm(W.magnets,De=>De.splice(le,1)),l.chosen=null})),Kb({stage:document.querySelector(".stage"),canvas:n("canvas"),view:o,now:()=>({body:f,parts:m,content:t,maps:p}),frozen:!!s,choose(W){l.chosen=W,I(),ie()},begin:z,move({kind:W,face:ne,number:le},De,Oe){ee(l.design,W,ne)[le]=De,x(Oe)},press(W,ne,le,De){let Oe=Array.from({length:h},(zt,vt)=>i.there.data[W*h+vt]?Math.hypot(D(vt)[0]-ne,D(vt)[1]-le):1/0),Xe={face:W,place:Oe.indexOf(Math.min(...Oe))},[ht]=l.presses,yt=De&&!s&&ht?.face===W&&ht.place!==Xe.place;de(yt?[ht,Xe]:[Xe]).catch(({message:zt})=>n("trouble").textContent=zt)}}),await x(),ge.watch(),window.instobjExplore={state:()=>l,idle:()=>!d&&!y&&!S,exact:()=>t.scene.endsWith("full"),latencies:()=>u,forget:()=>u.length=0,where:(W,ne)=>m.where(W,ne,o),at:(W,ne)=>m.at(W,ne),dent:()=>f.deepest(),map:()=>Array.from(i.map_live.data)},document.getElementById("instobj-explore").dataset.ready="yes"}function Wb({text:n,magnets:e,sensors:t}){let i=[...e.map(s=>`magnet ${s+1}`),...t.map(s=>`chip ${s+1}`)];return i.length?`${i.join(", ")}: ${n}`:n}function Xb(n,e){let t=La("tr",{});return t.append(La("th",{textContent:n})),e.forEach(i=>t.insertCell().append(i)),t}var qb=n=>[Math.min(...n),Math.max(...n)];function Zm(n,e){Object.entries(n).forEach(([t,i])=>t!=="positions_mm"&&Array.isArray(i)&&e(i))}function Yb(n,e){let i=Array.from({length:81},(r,o)=>[o%9/4-1,Math.floor(o/9)/4-1]).map(r=>r.map((o,a)=>Jm(.55*o*e.half_mm[a]))),s=i.map(r=>Math.min(...n.map(([o,a])=>Math.hypot(o-r[0],a-r[1])),1/0));return i[s.indexOf(Math.max(...s))]}function $b({content:n,arrays:e},t){let i=new mn({color:gn.silicone,transparent:!0}),s=rh(vs(e,"silicone"),i,[]);if(s.back.visible=!1,s.front.renderOrder=2,t.scene.add(s.group,Ra(s.front.geometry,[])),e.core_mm){let u=new Et(vs(e,"core"),new mn({color:gn.core,transparent:!0,opacity:.35,depthWrite:!1}));u.add(Ra(u.geometry,[])),t.scene.add(u)}n.faces.forEach(u=>xf(u,t));let r=u=>{i.opacity=u,i.depthWrite=u>.95,t.redraw()},o=new G,a=Kn(e.silicone_mm);function l(u){let{position:f}=s.front.geometry.attributes;f.array.set(a),u.forEach(h=>Zb(f.array,a,h,n.thickness_mm)),f.needsUpdate=!0,s.front.geometry.computeVertexNormals()}return{silicone:s,offset:()=>o,fade:r,bend:l,deepest:()=>s.front.geometry.attributes.position.array.reduce((u,f,h)=>Math.max(u,Math.abs(f-a[h])),0)}}function Zb(n,e,{origin:t,normal:i,profile:s},r){let[o,a]=[new G,s.at(-1)[0]],l=s[1][0];for(let c=0;c<e.length;c+=3){o.set(e[c]-t.x,e[c+1]-t.y,e[c+2]-t.z);let u=-o.dot(i),f=o.addScaledVector(i,u).length();if(f>=a||u>=r)continue;let h=Math.min(s.length-2,Math.floor(f/l)),[p,m]=[1,2].map(g=>s[h][g]+(f/l-h)*(s[h+1][g]-s[h][g])),_=1-Math.max(0,u)/r;o.multiplyScalar(f?m/f:0).addScaledVector(i,-p),n[c]+=_*o.x,n[c+1]+=_*o.y,n[c+2]+=_*o.z}}function Jb(n,e){let t={magnet:[],sensor:[],board:[]},i={magnet:Ss(n,()=>o("magnet",_f())),sensor:Ss(n,()=>o("sensor",Pa(gn.chip))),board:Ss(n,()=>o("board",Pa(gn.board)))},s=!e.magnets_in_shell,r={};function o(x,M){return M.traverse(N=>N.material&&Object.assign(N.material,{transparent:!0,opacity:.9})),M.traverse(N=>N.material&&(N.renderOrder=3)&&(N.userData.colour=N.material.color.getHex())),t[x].push(M),M}let a=s?"board":"magnet",[l,c]=[null,null];function u(x){l=x;let{magnets:M,chips:N,boards:A}=x;r={magnet:M.length,sensor:A.length,board:A.length};for(let[C,D]of[["magnet",M],["sensor",N],["board",A]])i[C].place(D.map((F,I)=>({...F,...f(C,I,F),half:F.half})))}function f(x,M,{at:N,axes:A}){let C=ah(A),D=Math.floor(M/_(x)),F=x===a&&c?.face===D?c.motions[M%_(x)]:null;if(!F||F.includes(null))return{at:N,turn:C};let{x:I,y:z,normal:X}=e.faces[D],B=(ee,re,Q)=>new G().addScaledVector(new G(...I),ee).addScaledVector(new G(...z),re).addScaledVector(new G(...X),Q),he=B(...F.slice(3)),Y=he.length();return Y&&C.premultiply(new an().setFromAxisAngle(he.divideScalar(Y),Y)),{at:B(...F).add(new G(...N)).toArray(),turn:C}}function h(x){c=x,l&&u(l)}let p=Ss(n,()=>dr("!",1,"#e01b24")),m=[],_=x=>r[x]/e.faces.length,g=x=>(x==="sensor"&&s?t.board:t[x]).slice(0,r[x]),d=(x,M)=>e.faces[Math.floor(M/_(x))],y=(x,M)=>m.some(N=>N[`${x}s`].includes(M%_(x))&&(!N.faces.length||N.faces.includes(d(x,M).number)));n.before.push(x=>{for(let N of["magnet","sensor","board"])t[N].slice(0,r[N]).forEach((A,C)=>A.visible=go(d(N,C),x));let M=["magnet","sensor"].flatMap(N=>g(N).filter((A,C)=>A.visible&&y(N,C)));p.place(M.map(N=>({at:N.position.toArray(),turn:N.quaternion,half:Array(3).fill(n.size/6)})))});function P(x,M,N){m=x;for(let A of["magnet","sensor"])g(A).forEach((C,D)=>{let F=M?.kind===A&&M.number===D%_(A)&&(d(A,D)===e.faces[M.face]||A==="magnet"&&N),I=y(A,D);C.traverse(z=>{z.material?.color.setHex(I?Fb:z.userData.colour),z.material?.emissive.setHex(I?6291456:F?5587968:0)})})}function S(x){let M=["magnet","sensor"].flatMap(A=>{let C=g(A).filter(D=>D.visible);return x.intersectObjects(C,!0).map(D=>({...D,kind:A,index:g(A).findIndex(F=>F===D.object||F===D.object.parent)}))}),[N]=M.filter(({index:A})=>A>=0).sort((A,C)=>A.distance-C.distance);return N&&{kind:N.kind,face:Math.floor(N.index/_(N.kind)),number:N.index%_(N.kind),at:g(N.kind)[N.index].position.clone()}}function E(x,M,{camera:N,renderer:A}){let C=A.domElement.getBoundingClientRect(),D=g(x)[M].position.clone().project(N);return[C.left+(D.x+1)/2*C.width,C.top+(1-D.y)/2*C.height]}return{place:u,move:h,paint:P,under:S,where:E,at:(x,M)=>g(x)[M].position.toArray()}}function Kb({stage:n,canvas:e,view:t,now:i,frozen:s,choose:r,begin:o,move:a,press:l}){let c=new gs,[u,f]=[new In,new G],h=null;function p(_){let g=e.getBoundingClientRect();c.setFromCamera(new Ye((_.clientX-g.left)/g.width*2-1,1-(_.clientY-g.top)/g.height*2),t.camera)}function m(_){let{body:g,content:d,maps:y}=i(),[P]=c.intersectObject(g.silicone.front,!1),S=P?Math.max(...[P.face.a,P.face.b,P.face.c].map(E=>y.owner[E])):-1;S>=0&&l(S,...Ca(d.faces[S],P.point.x,P.point.y,P.point.z),_)}n.addEventListener("pointerdown",_=>{if(_.target!==e||_.button)return;if(p(_),_.shiftKey)return _.stopPropagation(),m(_.altKey);let{parts:g,content:d}=i(),y=!s&&g.under(c);if(!y)return;_.stopPropagation();let P=new G(...d.faces[y.face].normal);u.setFromNormalAndCoplanarPoint(P,y.at),c.ray.intersectPlane(u,f),h={...y,from:[_.clientX,_.clientY],off:y.at.sub(f),moved:!1},r({kind:y.kind,face:y.face,number:y.number}),e.setPointerCapture(_.pointerId)},!0),e.addEventListener("pointermove",_=>{if(!h||!h.moved&&Math.hypot(_.clientX-h.from[0],_.clientY-h.from[1])<Bb||(p(_),!c.ray.intersectPlane(u,f)))return;h.moved||o(),h.moved=!0;let g=i().content.faces[h.face],d=f.add(h.off).sub(new G(...g.centre_mm)),y=[g.x,g.y].map((P,S)=>Jm(Math.min(Xm*g.half_mm[S],Math.max(-Xm*g.half_mm[S],d.dot(new G(...P))))));a(h,y,_.timeStamp)});for(let _ of["pointerup","pointercancel"])e.addEventListener(_,()=>h=null)}document.getElementById("instobj-explore")&&Hb().catch(n=>{document.querySelector('[data-name="trouble"]').textContent=`The page cannot start: ${n.message}.`,console.warn(n)});function Km(n){let e=n.attributes.position.array,t=n.index.array,i=new Float32Array(e.length),[s,r]=[0,0],o=new Float32Array(0);function a(u,f){[s,r]=[192,Math.max(1,Math.round(192/f))],o.length!==s*r&&(o=new Float32Array(s*r)),o.fill(0);let h=[0,0,0];for(let p=0;p<e.length;p+=3)u(e[p],e[p+1],e[p+2],h),i[p]=h[0]*s,i[p+1]=h[1]*r,i[p+2]=1/h[2];for(let p=0;p<t.length;p+=3)l(3*t[p],3*t[p+1],3*t[p+2])}function l(u,f,h){let[p,m,_,g,d,y]=[i[u],i[u+1],i[f],i[f+1],i[h],i[h+1]],P=(_-p)*(y-m)-(d-p)*(g-m);if(P>=0)return;let S=Math.max(0,Math.ceil(Math.min(p,_,d)-.5)),E=Math.min(s-1,Math.floor(Math.max(p,_,d)-.5)),b=Math.max(0,Math.ceil(Math.min(m,g,y)-.5)),x=Math.min(r-1,Math.floor(Math.max(m,g,y)-.5));for(let M=b;M<=x;M++)for(let N=S;N<=E;N++){let[A,C]=[N+.5,M+.5],D=((A-p)*(y-m)-(d-p)*(C-m))/P,F=((_-p)*(C-m)-(A-p)*(g-m))/P;if(D<0||F<0||D+F>1)continue;let I=i[u+2]+D*(i[f+2]-i[u+2])+F*(i[h+2]-i[u+2]),z=M*s+N;I>o[z]&&(o[z]=I)}}function c(u,f,h,p){let[m,_]=[Math.floor(u*s),Math.floor(f*r)];if(m<0||_<0||m>=s||_>=r)return!1;let g=o[_*s+m];return g>0&&1/g<h-p}return{draw:a,hides:c}}var fh="#d81b9a",jb="#0b5c3b",Qb=1.6,jm=.4,ew=.05,vf=40,dh=10,tw=Array.from({length:vf+1},(n,e)=>[Math.cos(2*Math.PI*e/vf),Math.sin(2*Math.PI*e/vf)]),Zs=(n,e,t)=>[n[0]+t*e[0],n[1]+t*e[1],n[2]+t*e[2]],Qm=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2];function eg([n,e,t]){let i=Math.abs(t)<.9?[-e,n,0]:[0,-t,e],s=Math.hypot(...i),[r,o,a]=i.map(l=>l/s);return[[r,o,a],[e*a-t*o,t*r-n*a,n*o-e*r]]}function tg(n,e,t){let i=e.getContext("2d"),s=Km(t),r=n.size/40,o=new G,[a,l,c,u]=[0,0,1,1],f=n.camera.projectionMatrix.elements,[h,p]=[[],[]];function m(A,C,D,F){let I=f,z=I[3]*A+I[7]*C+I[11]*D+I[15];F[0]=.5+(I[0]*A+I[4]*C+I[8]*D+I[12])/(2*z),F[1]=.5-(I[1]*A+I[5]*C+I[9]*D+I[13])/(2*z),F[2]=z}function _(A){let C=[0,0,0];return m(...A,C),{x:C[0]*a,y:C[1]*l,far:C[2],hidden:s.hides(...C,r)}}function g(A){A.updateMatrixWorld(),f=A.projectionMatrix.clone().multiply(A.matrixWorldInverse).elements,A.getWorldPosition(o),c=Math.min(devicePixelRatio,2),[a,l]=[e.clientWidth,e.clientHeight],u=A.projectionMatrix.elements[5]*l/2,(e.width!==Math.round(a*c)||e.height!==Math.round(l*c))&&([e.width,e.height]=[Math.round(a*c),Math.round(l*c)]),s.draw(m,A.aspect),x()}n.before.push(g);function d(A,C,D){let[F,I]=[new Path2D,new Path2D],z=null;for(let X=1;X<A.length;X++){let B=A[X-1].hidden||A[X].hidden?I:F;B!==z&&B.moveTo(A[X-1].x,A[X-1].y),B.lineTo(A[X].x,A[X].y),z=B}[i.strokeStyle,i.lineWidth]=[C,D],i.stroke(F),i.globalAlpha=jm,i.setLineDash([4,3]),i.stroke(I),i.setLineDash([]),i.globalAlpha=1}function y({point:A,normal:C}){return Qm([o.x-A[0],o.y-A[1],o.z-A[2]],C)<0}function P(A){let C=Number.isFinite(A.radius)?Math.max(A.radius,.05):.05,[D,F]=eg(A.normal),I=Zs(A.point,A.normal,.15),z=y(A),X=tw.map(([B,he])=>_(Zs(Zs(I,D,C*B),F,C*he)));z&&X.forEach(B=>B.hidden=!0),i.beginPath(),X.forEach(({x:B,y:he})=>i.lineTo(B,he)),i.globalAlpha=z||_(I).hidden?.12:.3,i.fillStyle=fh,i.fill(),i.globalAlpha=1,d(X,fh,1.5)}function S(A){let C=Math.hypot(...A.pull);if(C<1e-6)return{..._(A.point),left:!1};let D=A.pull.map(se=>se/C),F=C*Qb,I=n.size/110,z=Math.min(F,6*I),X=Zs(A.point,A.normal,.05),B=Array.from({length:dh+1},(se,ge)=>_(Zs(X,D,-z-(F-z)*(dh-ge)/dh))),[he,Y,ee]=[B[0],B[dh],_(X)],re=u/Y.far;d(B,fh,Math.max(2,2*I*re));let Q=2.6*I*re*(z/(6*I)),ie=Math.atan2(ee.y-Y.y,ee.x-Y.x),Z=[o.x-X[0],o.y-X[1],o.z-X[2]],de=Math.abs(Qm(Z,D))/Math.hypot(...Z);return i.globalAlpha=Y.hidden||y(A)?jm:1,i.fillStyle=fh,i.beginPath(),i.ellipse(Y.x,Y.y,Math.max(Q*de,.1),Q,ie,0,2*Math.PI),i.moveTo(Y.x-Q*Math.sin(ie),Y.y+Q*Math.cos(ie)),i.lineTo(ee.x,ee.y),i.lineTo(Y.x+Q*Math.sin(ie),Y.y-Q*Math.cos(ie)),i.fill(),i.globalAlpha=1,{...he,left:he.x<ee.x}}function E({force:A},{x:C,y:D,left:F}){let I=`${A.toFixed(1)} N`,z=i.measureText(I).width+10,X=F?C-6-z:C+6;i.fillStyle="#ffffffd8",i.fillRect(X,D-22,z,19),i.fillStyle="#a0126f",i.fillText(I,X+5,D-8)}function b(A){let[C,D]=eg(A.normal),F=n.size/18,I=Zs(A.point,A.normal,.25);for(let z of[C,D]){let X=[-1,-.5,0,.5,1].map(B=>_(Zs(I,z,B*F)));y(A)&&X.forEach(B=>B.hidden=!0),d(X,jb,2)}}function x(){i.setTransform(c,0,0,c,0,0),i.clearRect(0,0,a,l),i.lineCap="butt",i.font="600 13px system-ui, sans-serif",h.forEach(P),p.forEach(b);let A=h.map(S);h.forEach((C,D)=>E(C,A[D]))}function M(A,C){[h,p]=[A,C.filter(({force:D})=>D>=ew)],x()}return{show:M,shown:()=>h,told:()=>p,hidden:()=>h.map(A=>y(A)||_(Zs(A.point,A.normal,.15)).hidden)}}function ph(){let n=[];return{note(e,t=performance.now()){n.push([t,e]),n[0][0]<t-6e4&&(n=n.filter(([i])=>i>=t-6e4))},values:()=>n.map(([,e])=>e),since:e=>n.filter(([t])=>t>=e).map(([t])=>t),forget:()=>n=[]}}function mh(n){let e=n.sort((i,s)=>i-s),t=i=>e[Math.min(e.length-1,Math.floor(i*e.length))];return{count:e.length,p50:t(.5),p90:t(.9),p99:t(.99),most:e.at(-1)}}function ng(){let[n,e,t,i]=[ph(),ph(),ph(),ph()],s={shown:0,messages:0,rows:0,dropped:0},r=()=>performance.timeOrigin+performance.now(),o=({readS:h,arrivedS:p})=>1e3*(h||p);function a(h){let{rows:p,dropped:m}=h;i.note(r()-o(h)),s.messages+=1,s.rows+=p,s.dropped=m}function l(h){s.shown+=1,t.note(h)}function c(h){n.note(r()-o(h)),e.note(r()-1e3*h.arrivedS)}function u(){let h=t.since(performance.now()-3e3),p=h.length>1?1e3*(h.length-1)/(h.at(-1)-h[0]):0;return{...s,perSecond:p,latencyMs:mh(n.values()),underwayMs:mh(i.values()),ageMs:mh(e.values()),workMs:mh(t.values())}}function f(){[n,e,t,i].forEach(h=>h.forget()),Object.assign(s,{shown:0,messages:0,rows:0})}return{came:a,drawn:l,seen:c,told:u,forget:f}}var nw=n=>String.fromCharCode(...[0,1,2,3].map(e=>n.getUint8(e)));function ig(n,e){let t=new DataView(n);if(nw(t)==="IOS1")return{state:JSON.parse(new TextDecoder().decode(new Uint8Array(n,4)))};let[i,s,r]=[t.getUint16(4,!0),t.getUint8(6),t.getUint8(7)],o=new Float32Array(n,40),a=1+e,l=(c,u,f,h)=>Array.from({length:c},(p,m)=>h(o.subarray(f+m*u,f+(m+1)*u)));return{number:t.getUint32(8,!0),dropped:t.getUint32(12,!0),arrivedS:t.getFloat64(16,!0),readS:t.getFloat64(24,!0),timeS:t.getFloat64(32,!0),rows:i,values:o,wide:a,contacts:l(s,15,i*a,([c,u,f,h,p,m,..._])=>({face:c,x:u,y:f,radius:h,force:p,halfwidth:m,point:_.slice(0,3),normal:_.slice(3,6),pull:_.slice(6,9)})),labels:l(r,10,i*a+s*15,([c,u,f,h,...p])=>({face:c,x:u,y:f,force:h,point:p.slice(0,3),normal:p.slice(3,6)}))}}var iw="uplot",sw="u-hz",rw="u-vt",ow="u-title",aw="u-wrap",lw="u-under",cw="u-over",hw="u-axis",gr="u-off",uw="u-select",fw="u-cursor-x",dw="u-cursor-y",pw="u-cursor-pt",mw="u-legend",gw="u-live",_w="u-inline",xw="u-series",yw="u-marker",sg="u-label",vw="u-value",Na="width",Ua="height";var rg="bottom",_o="left",Sf="right",Bf="#000",og=Bf+"0",Mf="mousemove",ag="mousedown",bf="mouseup",lg="mouseenter",cg="mouseleave",hg="dblclick",Sw="resize",Mw="scroll",ug="change",vh="dppxchange",zf="--",wo=typeof window<"u",Cf=wo?document:null,yo=wo?window:null,bw=wo?navigator:null,At,gh;function Rf(){let n=devicePixelRatio;At!=n&&(At=n,gh&&If(ug,gh,Rf),gh=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),_r(ug,gh,Rf),yo.dispatchEvent(new CustomEvent(vh)))}function li(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Pf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function qt(n,e,t){n.style[e]=t+"px"}function Li(n,e,t,i){let s=Cf.createElement(n);return e!=null&&li(s,e),t?.insertBefore(s,i),s}function xi(n,e){return Li("div",n,e)}var fg=new WeakMap;function Qi(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=fg.get(n);r!=o&&(n.style.transform=r,fg.set(n,r),e<0||t<0||e>i||t>s?li(n,gr):Pf(n,gr))}var dg=new WeakMap;function pg(n,e,t){let i=e+t,s=dg.get(n);i!=s&&(dg.set(n,i),n.style.background=e,n.style.borderColor=t)}var mg=new WeakMap;function gg(n,e,t,i){let s=e+""+t,r=mg.get(n);s!=r&&(mg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var kf={passive:!0},ww={...kf,capture:!0};function _r(n,e,t,i){e.addEventListener(n,t,i?ww:kf)}function If(n,e,t,i){e.removeEventListener(n,t,kf)}wo&&Rf();function Di(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:ci((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Wg(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Xg=n=>n!=null,qg=n=>n!=null&&n>0,bh=Wg(Xg),Ew=Wg(qg);function Tw(n,e,t,i=0,s=!1){let r=s?Ew:bh,o=s?qg:Xg;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ot,l??-Ot]}function wh(n,e,t,i){let s=yg(n),r=yg(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ms:Yg,a=s==1?ci:yi,l=r==1?yi:ci,c=a(o(bn(n))),u=l(o(bn(e))),f=vo(t,c),h=vo(t,u);return t==10&&(c<0&&(f=Bt(f,-c)),u<0&&(h=Bt(h,-u))),i||t==2?(n=f*s,e=h*r):(n=Kg(n,f),e=Eh(e,h)),[n,e]}function Vf(n,e,t,i){let s=wh(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Gf=.1,_g={mode:3,pad:Gf},Oa={pad:0,soft:null,mode:0},Aw={min:Oa,max:Oa};function Sh(n,e,t,i){return Th(t)?xg(n,e,t):(Oa.pad=t,Oa.soft=i?0:null,Oa.mode=i?3:0,xg(n,e,Aw))}function Mt(n,e){return n??e}function Cw(n,e,t){for(e=Mt(e,0),t=Mt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function xg(n,e,t){let i=t.min,s=t.max,r=Mt(i.pad,0),o=Mt(s.pad,0),a=Mt(i.hard,-Ot),l=Mt(s.hard,Ot),c=Mt(i.soft,Ot),u=Mt(s.soft,-Ot),f=Mt(i.mode,0),h=Mt(s.mode,0),p=e-n,m=Ms(p),_=Jn(bn(n),bn(e)),g=Ms(_),d=bn(g-m);(p<1e-24||d>10)&&(p=0,(n==0||e==0)&&(p=1e-24,f==2&&c!=Ot&&(r=0),h==2&&u!=-Ot&&(o=0)));let y=p||_||1e3,P=Ms(y),S=vo(10,ci(P)),E=y*(p==0?n==0?.1:1:r),b=Bt(Kg(n-E,S/10),24),x=n>=c&&(f==1||f==3&&b<=c||f==2&&b>=c)?c:Ot,M=Jn(a,b<x&&n>=x?x:Ni(x,b)),N=y*(p==0?e==0?.1:1:o),A=Bt(Eh(e+N,S/10),24),C=e<=u&&(h==1||h==3&&A>=u||h==2&&A<=u)?u:-Ot,D=Ni(l,A>C&&e<=C?C:Jn(C,A));return M==D&&M==0&&(D=100),[M,D]}var Rw=new Intl.NumberFormat(wo?bw.language:"en-US"),Hf=n=>Rw.format(n),hi=Math,yh=hi.PI,bn=hi.abs,ci=hi.floor,Mn=hi.round,yi=hi.ceil,Ni=hi.min,Jn=hi.max,vo=hi.pow,yg=hi.sign,Ms=hi.log10,Yg=hi.log2,Pw=(n,e=1)=>hi.sinh(n)*e,wf=(n,e=1)=>hi.asinh(n/e),Ot=1/0;function vg(n){return(Ms((n^n>>31)-(n>>31))|0)+1}function Lf(n,e,t){return Ni(Jn(n,e),t)}function $g(n){return typeof n=="function"}function xt(n){return $g(n)?n:()=>n}var Iw=()=>{},Zg=n=>n,Jg=(n,e)=>e,Lw=n=>null,Sg=n=>!0,Mg=(n,e)=>n==e,Dw=/\.\d*?(?=9{6,}|0{6,})/gm,xr=n=>{if(Qg(n)||Ks.has(n))return n;let e=`${n}`,t=e.match(Dw);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${xr(s)}e${r}`}return Bt(n,i)};function pr(n,e){return xr(Bt(xr(n/e))*e)}function Eh(n,e){return xr(yi(xr(n/e))*e)}function Kg(n,e){return xr(ci(xr(n/e))*e)}function Bt(n,e=0){if(Qg(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mn(i)/t}var Ks=new Map;function jg(n){return((""+n).split(".")[1]||"").length}function za(n,e,t,i){let s=[],r=i.map(jg);for(let o=e;o<t;o++){let a=bn(o),l=Bt(vo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Bt(u,f);s.push(h),Ks.set(h,f)}}return s}var Ba={},Wf=[],So=[null,null],Js=Array.isArray,Qg=Number.isInteger,Nw=n=>n===void 0;function bg(n){return typeof n=="string"}function Th(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Uw(n){return n!=null&&typeof n=="object"}var Fw=Object.getPrototypeOf(Uint8Array),e0="__proto__";function Mo(n,e=Th){let t;if(Js(n)){let i=n.find(s=>s!=null);if(Js(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Mo(n[s],e)}else t=n.slice()}else if(n instanceof Fw)t=n.slice();else if(e(n)){t={};for(let i in n)i!=e0&&(t[i]=Mo(n[i],e))}else t=n;return t}function _n(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=e0&&(Th(n[s])?_n(n[s],Mo(i[s])):n[s]=Mo(i[s]))}return n}var Ow=0,Bw=1,zw=2;function kw(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Vw(n,e){if(Ww(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Xw(o[0])||(o=Hw(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:Bw,p=[];for(let m=0;m<u.length;m++){let _=u[m],g=r.get(l[m]);_===null?h!=Ow&&(f[g]=_,h==zw&&p.push(g)):f[g]=_}kw(f,p,s),i.push(f)}}return i}var Gw=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Hw(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Ww(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Xw(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Jn(1,ci((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var t0=["January","February","March","April","May","June","July","August","September","October","November","December"],n0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function i0(n){return n.slice(0,3)}var qw=n0.map(i0),Yw=t0.map(i0),$w={MMMM:t0,MMM:Yw,WWWW:n0,WWW:qw};function Da(n){return(n<10?"0":"")+n}function Zw(n){return(n<10?"00":n<100?"0":"")+n}var Jw={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Da(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Da(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Da(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Da(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Da(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Zw(n.getMilliseconds())};function Xf(n,e){e=e||$w;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Jw[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Kw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function jw(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Kw?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var s0=n=>n%1==0,Mh=[1,2,2.5,5],Qw=za(10,-32,0,Mh),r0=za(10,0,32,Mh),eE=r0.filter(s0),mr=Qw.concat(r0),qf=`
`,o0="{YYYY}",wg=qf+o0,a0="{M}/{D}",Fa=qf+a0,_h=Fa+"/{YY}",l0="{aa}",tE="{h}:{mm}",xo=tE+l0,Eg=qf+xo,Tg=":{ss}",Rt=null;function c0(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?za(10,0,3,Mh).filter(s0):za(10,-3,0,Mh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,o0,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",wg,Rt,Rt,Rt,Rt,Rt,1],[s,a0,wg,Rt,Rt,Rt,Rt,Rt,1],[i,"{h}"+l0,_h,Rt,Fa,Rt,Rt,Rt,1],[t,xo,_h,Rt,Fa,Rt,Rt,Rt,1],[e,Tg,_h+" "+xo,Rt,Fa+" "+xo,Rt,Eg,Rt,1],[n,Tg+".{fff}",_h+" "+xo,Rt,Fa+" "+xo,Rt,Eg,Rt,1]];function u(f){return(h,p,m,_,g,d)=>{let y=[],P=g>=o,S=g>=r&&g<o,E=f(m),b=Bt(E*n,3),x=Ef(E.getFullYear(),P?0:E.getMonth(),S||P?1:E.getDate()),M=Bt(x*n,3);if(S||P){let N=S?g/r:0,A=P?g/o:0,C=b==M?b:Bt(Ef(x.getFullYear()+A,x.getMonth()+N,1)*n,3),D=new Date(Mn(C/n)),F=D.getFullYear(),I=D.getMonth();for(let z=0;C<=_;z++){let X=Ef(F+A*z,I+N*z,1),B=X-f(Bt(X*n,3));C=Bt((+X+B)*n,3),C<=_&&y.push(C)}}else{let N=g>=s?s:g,A=ci(m)-ci(b),C=M+A+Eh(b-M,N);y.push(C);let D=f(C),F=D.getHours()+D.getMinutes()/t+D.getSeconds()/i,I=g/i,z=h.axes[p]._space,X=d/z;for(;C=Bt(C+g,n==1?0:3),!(C>_);)if(I>1){let B=ci(Bt(F+I,6))%24,ee=f(C).getHours()-B;ee>1&&(ee=-1),C-=ee*i,F=(F+I)%24;let re=y[y.length-1];Bt((C-re)/g,3)*X>=.7&&y.push(C)}else y.push(C)}return y}}return[l,c,u]}var[nE,iE,sE]=c0(1),[rE,oE,aE]=c0(.001);za(2,-53,53,[1]);function Ag(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Cg(n,e){return(t,i,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,f,h,p;return i.map(m=>{let _=n(m),g=_.getFullYear(),d=_.getMonth(),y=_.getDate(),P=_.getHours(),S=_.getMinutes(),E=_.getSeconds(),b=g!=l&&a[2]||d!=c&&a[3]||y!=u&&a[4]||P!=f&&a[5]||S!=h&&a[6]||E!=p&&a[7]||a[1];return l=g,c=d,u=y,f=P,h=S,p=E,b(_)})}}function lE(n,e){let t=Xf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Ef(n,e,t){return new Date(n,e,t)}function Rg(n,e){return e(n)}var cE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Pg(n,e){return(t,i,s,r)=>r==null?zf:e(n(i))}function hE(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function uE(n,e){return n.series[e].fill(n,e)}var fE={show:!0,live:!0,isolate:!1,mount:Iw,markers:{show:!0,width:2,stroke:hE,fill:uE,dash:"solid"},idx:null,idxs:null,values:[]};function dE(n,e){let t=n.cursor.points,i=xi(),s=t.size(n,e);qt(i,Na,s),qt(i,Ua,s);let r=s/-2;qt(i,"marginLeft",r),qt(i,"marginTop",r);let o=t.width(n,e,s);return o&&qt(i,"borderWidth",o),i}function pE(n,e){let t=n.series[e].points;return t._fill||t._stroke}function mE(n,e){let t=n.series[e].points;return t._stroke||t._fill}function gE(n,e){return n.series[e].points.size}var Tf=[0,0];function _E(n,e,t){return Tf[0]=e,Tf[1]=t,Tf}function xh(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Af(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var xE={show:!0,x:!0,y:!0,lock:!1,move:_E,points:{one:!1,show:dE,size:gE,width:0,stroke:mE,fill:pE},bind:{mousedown:xh,mouseup:xh,click:xh,dblclick:xh,mousemove:Af,mouseleave:Af,mouseenter:Af},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},h0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Yf=_n({},h0,{filter:Jg}),u0=_n({},Yf,{size:10}),f0=_n({},h0,{show:!1}),$f='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',d0="bold "+$f,p0=1.5,Ig={show:!0,scale:"x",stroke:Bf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:d0,side:2,grid:Yf,ticks:u0,border:f0,font:$f,lineGap:p0,rotate:0},yE="Value",vE="Time",Lg={show:!0,scale:"x",auto:!1,sorted:1,min:Ot,max:-Ot,idxs:[]};function SE(n,e,t,i,s){return e.map(r=>r==null?"":Hf(r))}function ME(n,e,t,i,s,r,o){let a=[],l=Ks.get(s)||0;t=o?t:Bt(Eh(t,s),l);for(let c=t;c<=i;c=Bt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Df(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ms:Yg,u=ci(c(t));s=vo(l,u),l==10&&(s=mr[Di(s,mr)]);let f=t,h=s*l;l==10&&(h=mr[Di(h,mr)]);do a.push(f),f=f+s,l==10&&!Ks.has(f)&&(f=Bt(f,Ks.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=mr[Di(h,mr)]));while(f<=i);return a}function bE(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Df(n,e,Jn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Df(n,e,Jn(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var m0=/./,wE=/[12357]/,EE=/[125]/,Dg=/1/,Nf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function TE(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?m0:l(7,o)-u>=c?wE:l(5,o)-u>=c?EE:Dg;if(f==Dg){let h=bn(l(1,o)-u);if(h<c)return Nf(e.slice().reverse(),a.distr,f,yi(c/h)).reverse()}return Nf(e,a.distr,f,1)}function AE(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=bn(l(1,o)-l(2,o));return c<a?Nf(e.slice().reverse(),3,m0,yi(a/c)).reverse():e}function CE(n,e,t,i){return i==null?zf:e==null?"":Hf(e)}var Ng={show:!0,scale:"y",stroke:Bf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:d0,side:3,grid:Yf,ticks:u0,border:f0,font:$f,lineGap:p0,rotate:0};function RE(n,e){let t=3+(n||1)*2;return Bt(t*e,3)}function PE(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=bn(o-r),l=n.series[e],c=a/(l.points.space*At);return i[1]-i[0]<=c}var Ug={scale:null,auto:!0,sorted:0,min:Ot,max:-Ot},g0=(n,e,t,i,s)=>s,Fg={show:!0,auto:!0,sorted:0,gaps:g0,alpha:1,facets:[_n({},Ug,{scale:"x"}),_n({},Ug,{scale:"y"})]},Og={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:g0,alpha:1,points:{show:PE,filter:null},values:null,min:Ot,max:-Ot,idxs:[],path:null,clip:null};function IE(n,e,t,i,s){return t/10}var _0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},LE=_n({},_0,{time:!1,ori:1}),Bg={};function x0(n,e){let t=Bg[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Bg[n]=t)),t}var bo=1,Uf=2;function yr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,p=a.top,m=a.width,_=a.height,g=n.valToPosH,d=n.valToPosV;return u.ori==0?t(s,l,c,u,f,g,d,h,p,m,_,Ch,Eo,Ph,v0,M0):t(s,l,c,u,f,d,g,p,h,_,m,Rh,To,Kf,S0,b0)}function Zf(n,e){let t=0,i=0,s=Mt(n.bands,Wf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function DE(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function bs(n,e,t,i,s,r){return yr(n,e,(o,a,l,c,u,f,h,p,m,_,g)=>{let d=o.pxRound,y=c.dir*(c.ori==0?1:-1),P=c.ori==0?Eo:To,S,E;y==1?(S=t,E=i):(S=i,E=t);let b=d(f(a[S],c,_,p)),x=d(h(l[S],u,g,m)),M=d(f(a[E],c,_,p)),N=d(h(r==1?u.max:u.min,u,g,m)),A=new Path2D(s);return P(A,M,N),P(A,b,N),P(A,b,x),A})}function Ah(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Ph:Kf,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let p=h[0]-l;p>0&&a(o,l,i,p,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function NE(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Jf(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let p=r(n[f]),m=h==f?p:r(n[h]),_=f-s;p=o<=0&&_>=0&&_<l?r(n[_]):p;let d=h+s;m=o>=0&&d>=0&&d<l?r(n[d]):m,m>=p&&a.push([p,m])}return a}function zg(n){return n==0?Zg:n==1?Mn:e=>pr(e,n)}function y0(n){let e=n==0?Ch:Rh,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Ni(c,a/2,l/2),u=Ni(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Ch=(n,e,t)=>{n.moveTo(e,t)},Rh=(n,e,t)=>{n.moveTo(t,e)},Eo=(n,e,t)=>{n.lineTo(e,t)},To=(n,e,t)=>{n.lineTo(t,e)},Ph=y0(0),Kf=y0(1),v0=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},S0=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},M0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},b0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function w0(n){return(e,t,i,s,r)=>yr(e,t,(o,a,l,c,u,f,h,p,m,_,g)=>{let{pxRound:d,points:y}=o,P,S;c.ori==0?(P=Ch,S=v0):(P=Rh,S=S0);let E=Bt(y.width*At,3),b=(y.size-y.width)/2*At,x=Bt(b*2,3),M=new Path2D,N=new Path2D,{left:A,top:C,width:D,height:F}=e.bbox;Ph(N,A-x,C-x,D+x*2,F+x*2);let I=z=>{if(l[z]!=null){let X=d(f(a[z],c,_,p)),B=d(h(l[z],u,g,m));P(M,X+b,B),S(M,X,B,b,0,yh*2)}};if(r)r.forEach(I);else for(let z=i;z<=s;z++)I(z);return{stroke:E>0?M:null,fill:M,clip:N,flags:bo|Uf}})}function E0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var UE=E0(Eo),FE=E0(To);function T0(n){let e=Mt(n?.alignGaps,0);return(t,i,s,r)=>yr(t,i,(o,a,l,c,u,f,h,p,m,_,g)=>{[s,r]=bh(l,s,r);let d=o.pxRound,y=F=>d(f(F,c,_,p)),P=F=>d(h(F,u,g,m)),S,E;c.ori==0?(S=Eo,E=UE):(S=To,E=FE);let b=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:bo},M=x.stroke,N=!1;if(r-s>=_*4){let F=ie=>t.posToVal(ie,c.key,!0),I=null,z=null,X,B,he,Y=y(a[b==1?s:r]),ee=y(a[s]),re=y(a[r]),Q=F(b==1?ee+1:re-1);for(let ie=b==1?s:r;ie>=s&&ie<=r;ie+=b){let Z=a[ie],se=(b==1?Z<Q:Z>Q)?Y:y(Z),ge=l[ie];se==Y?ge!=null?(B=ge,I==null?(S(M,se,P(B)),X=I=z=B):B<I?I=B:B>z&&(z=B)):ge===null&&(N=!0):(I!=null&&E(M,Y,P(I),P(z),P(X),P(B)),ge!=null?(B=ge,S(M,se,P(B)),I=z=X=B):(I=z=null,ge===null&&(N=!0)),Y=se,Q=F(Y+b))}I!=null&&I!=z&&he!=Y&&E(M,Y,P(I),P(z),P(X),P(B))}else for(let F=b==1?s:r;F>=s&&F<=r;F+=b){let I=l[F];I===null?N=!0:I!=null&&S(M,y(a[F]),P(I))}let[C,D]=Zf(t,i);if(o.fill!=null||C!=0){let F=x.fill=new Path2D(M),I=o.fillTo(t,i,o.min,o.max,C),z=P(I),X=y(a[s]),B=y(a[r]);b==-1&&([B,X]=[X,B]),S(F,B,z),S(F,X,z)}if(!o.spanGaps){let F=[];N&&F.push(...Jf(a,l,s,r,b,y,e)),x.gaps=F=o.gaps(t,i,s,r,F),x.clip=Ah(F,c.ori,p,m,_,g)}return D!=0&&(x.band=D==2?[bs(t,i,s,r,M,-1),bs(t,i,s,r,M,1)]:bs(t,i,s,r,M,D)),x})}function OE(n){let e=Mt(n.align,1),t=Mt(n.ascDesc,!1),i=Mt(n.alignGaps,0),s=Mt(n.extend,!1);return(r,o,a,l)=>yr(r,o,(c,u,f,h,p,m,_,g,d,y,P)=>{[a,l]=bh(f,a,l);let S=c.pxRound,{left:E,width:b}=r.bbox,x=ee=>S(m(ee,h,y,g)),M=ee=>S(_(ee,p,P,d)),N=h.ori==0?Eo:To,A={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:bo},C=A.stroke,D=h.dir*(h.ori==0?1:-1),F=M(f[D==1?a:l]),I=x(u[D==1?a:l]),z=I,X=I;s&&e==-1&&(X=E,N(C,X,F)),N(C,I,F);for(let ee=D==1?a:l;ee>=a&&ee<=l;ee+=D){let re=f[ee];if(re==null)continue;let Q=x(u[ee]),ie=M(re);e==1?N(C,Q,F):N(C,z,ie),N(C,Q,ie),F=ie,z=Q}let B=z;s&&e==1&&(B=E+b,N(C,B,F));let[he,Y]=Zf(r,o);if(c.fill!=null||he!=0){let ee=A.fill=new Path2D(C),re=c.fillTo(r,o,c.min,c.max,he),Q=M(re);N(ee,B,Q),N(ee,X,Q)}if(!c.spanGaps){let ee=[];ee.push(...Jf(u,f,a,l,D,x,i));let re=c.width*At/2,Q=t||e==1?re:-re,ie=t||e==-1?-re:re;ee.forEach(Z=>{Z[0]+=Q,Z[1]+=ie}),A.gaps=ee=c.gaps(r,o,a,l,ee),A.clip=Ah(ee,h.ori,g,d,y,P)}return Y!=0&&(A.band=Y==2?[bs(r,o,a,l,C,-1),bs(r,o,a,l,C,1)]:bs(r,o,a,l,C,Y)),A})}function kg(n,e,t,i,s,r,o=Ot){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=bn(n[l]-n[a]);u<c&&(c=u,o=bn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function BE(n){n=n||Ba;let e=Mt(n.size,[.6,Ot,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=xt(s),o=1-e[0],a=Mt(e[1],Ot),l=Mt(e[2],1),c=Mt(n.disp,Ba),u=Mt(n.each,p=>{}),{fill:f,stroke:h}=c;return(p,m,_,g)=>yr(p,m,(d,y,P,S,E,b,x,M,N,A,C)=>{let D=d.pxRound,F=t,I=i*At,z=a*At,X=l*At,B,he;S.ori==0?[B,he]=r(p,m):[he,B]=r(p,m);let Y=S.dir*(S.ori==0?1:-1),ee=S.ori==0?Ph:Kf,re=S.ori==0?u:(Ie,Ke,ot,Te,Ut,We,Ze)=>{u(Ie,Ke,ot,Ut,Te,Ze,We)},Q=Mt(p.bands,Wf).find(Ie=>Ie.series[0]==m),ie=Q!=null?Q.dir:0,Z=d.fillTo(p,m,d.min,d.max,ie),de=D(x(Z,E,C,N)),se,ge,me,W=A,ne=D(d.width*At),le=!1,De=null,Oe=null,Xe=null,ht=null;f!=null&&(ne==0||h!=null)&&(le=!0,De=f.values(p,m,_,g),Oe=new Map,new Set(De).forEach(Ie=>{Ie!=null&&Oe.set(Ie,new Path2D)}),ne>0&&(Xe=h.values(p,m,_,g),ht=new Map,new Set(Xe).forEach(Ie=>{Ie!=null&&ht.set(Ie,new Path2D)})));let{x0:yt,size:zt}=c;if(yt!=null&&zt!=null){F=1,y=yt.values(p,m,_,g),yt.unit==2&&(y=y.map(ot=>p.posToVal(M+ot*A,S.key,!0)));let Ie=zt.values(p,m,_,g);zt.unit==2?ge=Ie[0]*A:ge=b(Ie[0],S,A,M)-b(0,S,A,M),W=kg(y,P,b,S,A,M,W),me=W-ge+I}else W=kg(y,P,b,S,A,M,W),me=W*o+I,ge=W-me;me<1&&(me=0),ne>=ge/2&&(ne=0),me<5&&(D=Zg);let vt=me>0,Kt=W-me-(vt?ne:0);ge=D(Lf(Kt,X,z)),se=(F==0?ge/2:F==Y?0:ge)-F*Y*((F==0?I/2:0)+(vt?ne/2:0));let mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},sn=le?null:new Path2D,Nt=null;if(Q!=null)Nt=p.data[Q.series[1]];else{let{y0:Ie,y1:Ke}=c;Ie!=null&&Ke!=null&&(P=Ke.values(p,m,_,g),Nt=Ie.values(p,m,_,g))}let jt=B*ge,V=he*ge;for(let Ie=Y==1?_:g;Ie>=_&&Ie<=g;Ie+=Y){let Ke=P[Ie];if(Ke==null)continue;if(Nt!=null){let $=Nt[Ie]??0;if(Ke-$==0)continue;de=x($,E,C,N)}let ot=S.distr!=2||c!=null?y[Ie]:Ie,Te=b(ot,S,A,M),Ut=x(Mt(Ke,Z),E,C,N),We=D(Te-se),Ze=D(Jn(Ut,de)),L=D(Ni(Ut,de)),w=Ze-L;if(Ke!=null){let $=Ke<0?V:jt,xe=Ke<0?jt:V;le?(ne>0&&Xe[Ie]!=null&&ee(ht.get(Xe[Ie]),We,L+ci(ne/2),ge,Jn(0,w-ne),$,xe),De[Ie]!=null&&ee(Oe.get(De[Ie]),We,L+ci(ne/2),ge,Jn(0,w-ne),$,xe)):ee(sn,We,L+ci(ne/2),ge,Jn(0,w-ne),$,xe),re(p,m,Ie,We-ne/2,L,ge+ne,w)}}return ne>0?mt.stroke=le?ht:sn:le||(mt._fill=d.width==0?d._fill:d._stroke??d._fill,mt.width=0),mt.fill=le?Oe:sn,mt})}function zE(n,e){let t=Mt(e?.alignGaps,0);return(i,s,r,o)=>yr(i,s,(a,l,c,u,f,h,p,m,_,g,d)=>{[r,o]=bh(c,r,o);let y=a.pxRound,P=B=>y(h(B,u,g,m)),S=B=>y(p(B,f,d,_)),E,b,x;u.ori==0?(E=Ch,x=Eo,b=M0):(E=Rh,x=To,b=b0);let M=u.dir*(u.ori==0?1:-1),N=P(l[M==1?r:o]),A=N,C=[],D=[];for(let B=M==1?r:o;B>=r&&B<=o;B+=M)if(c[B]!=null){let Y=l[B],ee=P(Y);C.push(A=ee),D.push(S(c[B]))}let F={stroke:n(C,D,E,x,b,y),fill:null,clip:null,band:null,gaps:null,flags:bo},I=F.stroke,[z,X]=Zf(i,s);if(a.fill!=null||z!=0){let B=F.fill=new Path2D(I),he=a.fillTo(i,s,a.min,a.max,z),Y=S(he);x(B,A,Y),x(B,N,Y)}if(!a.spanGaps){let B=[];B.push(...Jf(l,c,r,o,M,P,t)),F.gaps=B=a.gaps(i,s,r,o,B),F.clip=Ah(B,u.ori,m,_,g,d)}return X!=0&&(F.band=X==2?[bs(i,s,r,o,I,-1),bs(i,s,r,o,I,1)]:bs(i,s,r,o,I,X)),F})}function kE(n){return zE(VE,n)}function VE(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var Ff=new Set;function Vg(){for(let n of Ff)n.syncRect(!0)}wo&&(_r(Sw,yo,Vg),_r(Mw,yo,Vg,!0),_r(vh,yo,()=>{Fn.pxRatio=At}));var GE=T0(),HE=w0();function Gg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Of(r,o,e,t))}function WE(n,e){return n.map((t,i)=>i==0?{}:_n({},e,t))}function Of(n,e,t,i){return _n({},e==0?t:i,n)}function A0(n,e,t){return e==null?So:[e,t]}var XE=A0;function qE(n,e,t){return e==null?So:Sh(e,t,Gf,!0)}function C0(n,e,t,i){return e==null?So:wh(e,t,n.scales[i].log,!1)}var YE=C0;function R0(n,e,t,i){return e==null?So:Vf(e,t,n.scales[i].log,!1)}var $E=R0;function ZE(n,e,t,i,s){let r=Jn(vg(n),vg(e)),o=e-n,a=Di(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Ks.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Hg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Mn((t=+s)*At))+"px"),[n,e,t]}function JE(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Bt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Fn(n,e,t){let i={mode:Mt(n.mode,1)},s=i.mode;function r(v,T,U,O){let q=T.valToPct(v);return O+U*(T.dir==-1?1-q:q)}function o(v,T,U,O){let q=T.valToPct(v);return O+U*(T.dir==-1?q:1-q)}function a(v,T,U,O){return T.ori==0?r(v,T,U,O):o(v,T,U,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=xi(iw);if(n.id!=null&&(c.id=n.id),li(c,n.class),n.title){let v=xi(ow,c);v.textContent=n.title}let u=Li("canvas"),f=i.ctx=u.getContext("2d"),h=xi(aw,c);_r("click",h,v=>{v.target===m&&(Vt!=Tr||Yt!=Ar)&&Pn.click(i,v)},!0);let p=i.under=xi(lw,h);h.appendChild(u);let m=i.over=xi(cw,h);n=Mo(n);let _=+Mt(n.pxAlign,1),g=zg(_);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let d=n.ms||.001,y=i.series=s==1?Gg(n.series||[],Lg,Og,!1):WE(n.series||[null],Fg),P=i.axes=Gg(n.axes||[],Ig,Ng,!0),S=i.scales={},E=i.bands=n.bands||[];E.forEach(v=>{v.fill=xt(v.fill||null),v.dir=Mt(v.dir,-1)});let b=s==2?y[1].facets[0].scale:y[0].scale,x={axes:is,series:ft},M=(n.drawOrder||["axes","series"]).map(v=>x[v]);function N(v){let T=v.distr==3?U=>Ms(U>0?U:v.clamp(i,U,v.min,v.max,v.key)):v.distr==4?U=>wf(U,v.asinh):v.distr==100?U=>v.fwd(U):U=>U;return U=>{let O=T(U),{_min:q,_max:j}=v,pe=j-q;return(O-q)/pe}}function A(v){let T=S[v];if(T==null){let U=(n.scales||Ba)[v]||Ba;if(U.from!=null){A(U.from);let O=_n({},S[U.from],U,{key:v});O.valToPct=N(O),S[v]=O}else{T=S[v]=_n({},v==b?_0:LE,U),T.key=v;let O=T.time,q=T.range,j=Js(q);if((v!=b||s==2&&!O)&&(j&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?_g:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?_g:{mode:1,hard:q[1],soft:q[1]}},j=!1),!j&&Th(q))){let pe=q;q=(ye,we,Fe)=>we==null?So:Sh(we,Fe,pe)}T.range=xt(q||(O?XE:v==b?T.distr==3?YE:T.distr==4?$E:A0:T.distr==3?C0:T.distr==4?R0:qE)),T.auto=xt(j?!1:T.auto),T.clamp=xt(T.clamp||IE),T._min=T._max=null,T.valToPct=N(T)}}}A("x"),A("y"),s==1&&y.forEach(v=>{A(v.scale)}),P.forEach(v=>{A(v.scale)});for(let v in n.scales)A(v);let C=S[b],D=C.distr,F,I;C.ori==0?(li(c,sw),F=r,I=o):(li(c,rw),F=o,I=r);let z={};for(let v in S){let T=S[v];(T.min!=null||T.max!=null)&&(z[v]={min:T.min,max:T.max},T.min=T.max=null)}let X=n.tzDate||(v=>new Date(Mn(v/d))),B=n.fmtDate||Xf,he=d==1?sE(X):aE(X),Y=Cg(X,Ag(d==1?iE:oE,B)),ee=Pg(X,Rg(cE,B)),re=[],Q=i.legend=_n({},fE,n.legend),ie=i.cursor=_n({},xE,{drag:{y:s==2}},n.cursor),Z=Q.show,de=ie.show,se=Q.markers;Q.idxs=re,se.width=xt(se.width),se.dash=xt(se.dash),se.stroke=xt(se.stroke),se.fill=xt(se.fill);let ge,me,W,ne=[],le=[],De,Oe=!1,Xe={};if(Q.live){let v=y[1]?y[1].values:null;Oe=v!=null,De=Oe?v(i,1,0):{_:0};for(let T in De)Xe[T]=zf}if(Z)if(ge=Li("table",mw,c),W=Li("tbody",null,ge),Q.mount(i,ge),Oe){me=Li("thead",null,ge,W);let v=Li("tr",null,me);Li("th",null,v);for(var ht in De)Li("th",sg,v).textContent=ht}else li(ge,_w),Q.live&&li(ge,gw);let yt={show:!0},zt={show:!1};function vt(v,T){if(T==0&&(Oe||!Q.live||s==2))return So;let U=[],O=Li("tr",xw,W,W.childNodes[T]);li(O,v.class),v.show||li(O,gr);let q=Li("th",null,O);if(se.show){let ye=xi(yw,q);if(T>0){let we=se.width(i,T);we&&(ye.style.border=we+"px "+se.dash(i,T)+" "+se.stroke(i,T)),ye.style.background=se.fill(i,T)}}let j=xi(sg,q);v.label instanceof HTMLElement?j.appendChild(v.label):j.textContent=v.label,T>0&&(se.show||(j.style.color=v.width>0?se.stroke(i,T):se.fill(i,T)),mt("click",q,ye=>{if(ie._lock)return;et(ye);let we=y.indexOf(v);if((ye.ctrlKey||ye.metaKey)!=Q.isolate){let Fe=y.some((Be,ke)=>ke>0&&ke!=we&&Be.show);y.forEach((Be,ke)=>{ke>0&&zi(ke,Fe?ke==we?yt:zt:yt,!0,un.setSeries)})}else zi(we,{show:!v.show},!0,un.setSeries)},!1),tt&&mt(lg,q,ye=>{ie._lock||(et(ye),zi(y.indexOf(v),Rr,!0,un.setSeries))},!1));for(var pe in De){let ye=Li("td",vw,O);ye.textContent="--",U.push(ye)}return[O,U]}let Kt=new Map;function mt(v,T,U,O=!0){let q=Kt.get(T)||{},j=ie.bind[v](i,T,U,O);j&&(_r(v,T,q[v]=j),Kt.set(T,q))}function sn(v,T,U){let O=Kt.get(T)||{};for(let q in O)(v==null||q==v)&&(If(q,T,O[q]),delete O[q]);v==null&&Kt.delete(T)}let Nt=0,jt=0,V=0,Ie=0,Ke=0,ot=0,Te=Ke,Ut=ot,We=V,Ze=Ie,L=0,w=0,$=0,xe=0;i.bbox={};let fe=!1,Me=!1,be=!1,oe=!1,ce=!1,ve=!1;function k(v,T,U){(U||v!=i.width||T!=i.height)&&ue(v,T),lt(!1),be=!0,Me=!0,On()}function ue(v,T){i.width=Nt=V=v,i.height=jt=Ie=T,Ke=ot=0,Ee(),qe();let U=i.bbox;L=U.left=pr(Ke*At,.5),w=U.top=pr(ot*At,.5),$=U.width=pr(V*At,.5),xe=U.height=pr(Ie*At,.5)}let ae=3;function Ae(){let v=!1,T=0;for(;!v;){T++;let U=br(T),O=Bi(T);v=T==ae||U&&O,v||(ue(i.width,i.height),Me=!0)}}function Se({width:v,height:T}){k(v,T)}i.setSize=Se;function Ee(){let v=!1,T=!1,U=!1,O=!1;P.forEach((q,j)=>{if(q.show&&q._show){let{side:pe,_size:ye}=q,we=pe%2,Fe=q.label!=null?q.labelSize:0,Be=ye+Fe;Be>0&&(we?(V-=Be,pe==3?(Ke+=Be,O=!0):U=!0):(Ie-=Be,pe==0?(ot+=Be,v=!0):T=!0))}}),Fi[0]=v,Fi[1]=U,Fi[2]=T,Fi[3]=O,V-=vi[1]+vi[3],Ke+=vi[3],Ie-=vi[2]+vi[0],ot+=vi[0]}function qe(){let v=Ke+V,T=ot+Ie,U=Ke,O=ot;function q(j,pe){switch(j){case 1:return v+=pe,v-pe;case 2:return T+=pe,T-pe;case 3:return U-=pe,U+pe;case 0:return O-=pe,O+pe}}P.forEach((j,pe)=>{if(j.show&&j._show){let ye=j.side;j._pos=q(ye,j._size),j.label!=null&&(j._lpos=q(ye,j.labelSize))}})}if(ie.dataIdx==null){let v=ie.hover,T=v.skip=new Set(v.skip??[]);T.add(void 0);let U=v.prox=xt(v.prox),O=v.bias??=0;ie.dataIdx=(q,j,pe,ye)=>{if(j==0)return pe;let we=pe,Fe=U(q,j,pe,ye)??Ot,Be=Fe>=0&&Fe<Ot,ke=C.ori==0?V:Ie,st=ie.left,bt=e[0],St=e[j];if(T.has(St[pe])){we=null;let pt=null,je=null,$e;if(O==0||O==-1)for($e=pe;pt==null&&$e-- >0;)T.has(St[$e])||(pt=$e);if(O==0||O==1)for($e=pe;je==null&&$e++<St.length;)T.has(St[$e])||(je=$e);if(pt!=null||je!=null)if(Be){let Ht=pt==null?-1/0:F(bt[pt],C,ke,0),tn=je==null?1/0:F(bt[je],C,ke,0),An=st-Ht,Dt=tn-st;An<=Dt?An<=Fe&&(we=pt):Dt<=Fe&&(we=je)}else we=je==null?pt:pt==null?je:pe-pt<=je-pe?pt:je}else Be&&bn(st-F(bt[pe],C,ke,0))>Fe&&(we=null);return we}}let et=v=>{ie.event=v};ie.idxs=re,ie._lock=!1;let _e=ie.points;_e.show=xt(_e.show),_e.size=xt(_e.size),_e.stroke=xt(_e.stroke),_e.width=xt(_e.width),_e.fill=xt(_e.fill);let Ve=i.focus=_n({},n.focus||{alpha:.3},ie.focus),tt=Ve.prox>=0,Pe=tt&&_e.one,at=[],kt=[],Gn=[];function Ao(v,T){let U=_e.show(i,T);if(U instanceof HTMLElement)return li(U,pw),li(U,v.class),Qi(U,-10,-10,V,Ie),m.insertBefore(U,at[T]),U}function vr(v,T){if(s==1||T>0){let U=s==1&&S[v.scale].time,O=v.value;v.value=U?bg(O)?Pg(X,Rg(O,B)):O||ee:O||CE,v.label=v.label||(U?vE:yE)}if(Pe||T>0){v.width=v.width==null?1:v.width,v.paths=v.paths||GE||Lw,v.fillTo=xt(v.fillTo||DE),v.pxAlign=+Mt(v.pxAlign,_),v.pxRound=zg(v.pxAlign),v.stroke=xt(v.stroke||null),v.fill=xt(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let U=RE(Jn(1,v.width),1),O=v.points=_n({},{size:U,width:Jn(1,U*.2),stroke:v.stroke,space:U*2,paths:HE,_stroke:null,_fill:null},v.points);O.show=xt(O.show),O.filter=xt(O.filter),O.fill=xt(O.fill),O.stroke=xt(O.stroke),O.paths=xt(O.paths),O.pxAlign=v.pxAlign}if(Z){let U=vt(v,T);ne.splice(T,0,U[0]),le.splice(T,0,U[1]),Q.values.push(null)}if(de){re.splice(T,0,null);let U=null;Pe?T==0&&(U=Ao(v,T)):T>0&&(U=Ao(v,T)),at.splice(T,0,U),kt.splice(T,0,0),Gn.splice(T,0,0)}Tn("addSeries",T)}function Ih(v,T){T=T??y.length,v=s==1?Of(v,T,Lg,Og):Of(v,T,{},Fg),y.splice(T,0,v),vr(y[T],T)}i.addSeries=Ih;function ka(v){if(y.splice(v,1),Z){Q.values.splice(v,1),le.splice(v,1);let T=ne.splice(v,1)[0];sn(null,T.firstChild),T.remove()}de&&(re.splice(v,1),at.splice(v,1)[0].remove(),kt.splice(v,1),Gn.splice(v,1)),Tn("delSeries",v)}i.delSeries=ka;let Fi=[!1,!1,!1,!1];function es(v,T){if(v._show=v.show,v.show){let U=v.side%2,O=S[v.scale];O==null&&(v.scale=U?y[1].scale:b,O=S[v.scale]);let q=O.time;v.size=xt(v.size),v.space=xt(v.space),v.rotate=xt(v.rotate),Js(v.incrs)&&v.incrs.forEach(pe=>{!Ks.has(pe)&&Ks.set(pe,jg(pe))}),v.incrs=xt(v.incrs||(O.distr==2?eE:q?d==1?nE:rE:mr)),v.splits=xt(v.splits||(q&&O.distr==1?he:O.distr==3?Df:O.distr==4?bE:ME)),v.stroke=xt(v.stroke),v.grid.stroke=xt(v.grid.stroke),v.ticks.stroke=xt(v.ticks.stroke),v.border.stroke=xt(v.border.stroke);let j=v.values;v.values=Js(j)&&!Js(j[0])?xt(j):q?Js(j)?Cg(X,Ag(j,B)):bg(j)?lE(X,j):j||Y:j||SE,v.filter=xt(v.filter||(O.distr>=3&&O.log==10?TE:O.distr==3&&O.log==2?AE:Jg)),v.font=Hg(v.font),v.labelFont=Hg(v.labelFont),v._size=v.size(i,null,T,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Fi[T]=!0,v._el=xi(hw,h))}}function ts(v,T,U,O){let[q,j,pe,ye]=U,we=T%2,Fe=0;return we==0&&(ye||j)&&(Fe=T==0&&!q||T==2&&!pe?Mn(Ig.size/3):0),we==1&&(q||pe)&&(Fe=T==1&&!j||T==3&&!ye?Mn(Ng.size/2):0),Fe}let Co=i.padding=(n.padding||[ts,ts,ts,ts]).map(v=>xt(Mt(v,ts))),vi=i._padding=Co.map((v,T)=>v(i,T,Fi,0)),Qt,rn=null,on=null,Oi=s==1?y[0].idxs:null,ei=null,Es=!1;function Ro(v,T){if(e=v??[],i.data=i._data=e,s==2){Qt=0;for(let U=1;U<y.length;U++)Qt+=e[U][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ei=e[0],Qt=ei.length;let U=e;if(D==2){U=e.slice();let O=U[0]=Array(Qt);for(let q=0;q<Qt;q++)O[q]=q}i._data=e=U}if(lt(!0),Tn("setData"),D==2&&(be=!0),T!==!1){let U=C;U.auto(i,Es)?Po():Cs(b,U.min,U.max),oe=oe||ie.left>=0,ve=!0,On()}}i.setData=Ro;function Po(){Es=!0;let v,T;s==1&&(Qt>0?(rn=Oi[0]=0,on=Oi[1]=Qt-1,v=e[0][rn],T=e[0][on],D==2?(v=rn,T=on):v==T&&(D==3?[v,T]=wh(v,v,C.log,!1):D==4?[v,T]=Vf(v,v,C.log,!1):C.time?T=v+Mn(86400/d):[v,T]=Sh(v,T,Gf,!0))):(rn=Oi[0]=v=null,on=Oi[1]=T=null)),Cs(b,v,T)}let Sr,Ts,Mr,R,H,te,J,K,Ce,Le;function Re(v,T,U,O,q,j){v??=og,U??=Wf,O??="butt",q??=og,j??="round",v!=Sr&&(f.strokeStyle=Sr=v),q!=Ts&&(f.fillStyle=Ts=q),T!=Mr&&(f.lineWidth=Mr=T),j!=H&&(f.lineJoin=H=j),O!=te&&(f.lineCap=te=O),U!=R&&f.setLineDash(R=U)}function Ne(v,T,U,O){T!=Ts&&(f.fillStyle=Ts=T),v!=J&&(f.font=J=v),U!=K&&(f.textAlign=K=U),O!=Ce&&(f.textBaseline=Ce=O)}function He(v,T,U,O,q=0){if(O.length>0&&v.auto(i,Es)&&(T==null||T.min==null)){let j=Mt(rn,0),pe=Mt(on,O.length-1),ye=U.min==null?Tw(O,j,pe,q,v.distr==3):[U.min,U.max];v.min=Ni(v.min,U.min=ye[0]),v.max=Jn(v.max,U.max=ye[1])}}let nt={min:null,max:null};function ut(){for(let O in S){let q=S[O];z[O]==null&&(q.min==null||z[b]!=null&&q.auto(i,Es))&&(z[O]=nt)}for(let O in S){let q=S[O];z[O]==null&&q.from!=null&&z[q.from]!=null&&(z[O]=nt)}z[b]!=null&&lt(!0);let v={};for(let O in z){let q=z[O];if(q!=null){let j=v[O]=Mo(S[O],Uw);if(q.min!=null)_n(j,q);else if(O!=b||s==2)if(Qt==0&&j.from==null){let pe=j.range(i,null,null,O);j.min=pe[0],j.max=pe[1]}else j.min=Ot,j.max=-Ot}}if(Qt>0){y.forEach((O,q)=>{if(s==1){let j=O.scale,pe=z[j];if(pe==null)return;let ye=v[j];if(q==0){let we=ye.range(i,ye.min,ye.max,j);ye.min=we[0],ye.max=we[1],rn=Di(ye.min,e[0]),on=Di(ye.max,e[0]),on-rn>1&&(e[0][rn]<ye.min&&rn++,e[0][on]>ye.max&&on--),O.min=ei[rn],O.max=ei[on]}else O.show&&O.auto&&He(ye,pe,O,e[q],O.sorted);O.idxs[0]=rn,O.idxs[1]=on}else if(q>0&&O.show&&O.auto){let[j,pe]=O.facets,ye=j.scale,we=pe.scale,[Fe,Be]=e[q],ke=v[ye],st=v[we];ke!=null&&He(ke,z[ye],j,Fe,j.sorted),st!=null&&He(st,z[we],pe,Be,pe.sorted),O.min=pe.min,O.max=pe.max}});for(let O in v){let q=v[O],j=z[O];if(q.from==null&&(j==null||j.min==null)){let pe=q.range(i,q.min==Ot?null:q.min,q.max==-Ot?null:q.max,O);q.min=pe[0],q.max=pe[1]}}}for(let O in v){let q=v[O];if(q.from!=null){let j=v[q.from];if(j.min==null)q.min=q.max=null;else{let pe=q.range(i,j.min,j.max,O);q.min=pe[0],q.max=pe[1]}}}let T={},U=!1;for(let O in v){let q=v[O],j=S[O];if(j.min!=q.min||j.max!=q.max){j.min=q.min,j.max=q.max;let pe=j.distr;j._min=pe==3?Ms(j.min):pe==4?wf(j.min,j.asinh):pe==100?j.fwd(j.min):j.min,j._max=pe==3?Ms(j.max):pe==4?wf(j.max,j.asinh):pe==100?j.fwd(j.max):j.max,T[O]=U=!0}}if(U){y.forEach((O,q)=>{s==2?q>0&&T.y&&(O._paths=null):T[O.scale]&&(O._paths=null)});for(let O in T)be=!0,Tn("setScale",O);de&&ie.left>=0&&(oe=ve=!0)}for(let O in z)z[O]=null}function Ge(v){let T=Lf(rn-1,0,Qt-1),U=Lf(on+1,0,Qt-1);for(;v[T]==null&&T>0;)T--;for(;v[U]==null&&U<Qt-1;)U++;return[T,U]}function ft(){if(Qt>0){let v=y.some(T=>T._focus)&&Le!=Ve.alpha;v&&(f.globalAlpha=Le=Ve.alpha),y.forEach((T,U)=>{if(U>0&&T.show&&(Jt(U,!1),Jt(U,!0),T._paths==null)){let O=Le;Le!=T.alpha&&(f.globalAlpha=Le=T.alpha);let q=s==2?[0,e[U][0].length-1]:Ge(e[U]);T._paths=T.paths(i,U,q[0],q[1]),Le!=O&&(f.globalAlpha=Le=O)}}),y.forEach((T,U)=>{if(U>0&&T.show){let O=Le;Le!=T.alpha&&(f.globalAlpha=Le=T.alpha),T._paths!=null&&Pt(U,!1);{let q=T._paths!=null?T._paths.gaps:null,j=T.points.show(i,U,rn,on,q),pe=T.points.filter(i,U,j,q);(j||pe)&&(T.points._paths=T.points.paths(i,U,rn,on,pe),Pt(U,!0))}Le!=O&&(f.globalAlpha=Le=O),Tn("drawSeries",U)}}),v&&(f.globalAlpha=Le=1)}}function Jt(v,T){let U=T?y[v].points:y[v];U._stroke=U.stroke(i,v),U._fill=U.fill(i,v)}function Pt(v,T){let U=T?y[v].points:y[v],{stroke:O,fill:q,clip:j,flags:pe,_stroke:ye=U._stroke,_fill:we=U._fill,_width:Fe=U.width}=U._paths;Fe=Bt(Fe*At,3);let Be=null,ke=Fe%2/2;T&&we==null&&(we=Fe>0?"#fff":ye);let st=U.pxAlign==1&&ke>0;if(st&&f.translate(ke,ke),!T){let bt=L-Fe/2,St=w-Fe/2,pt=$+Fe,je=xe+Fe;Be=new Path2D,Be.rect(bt,St,pt,je)}T?ze(ye,Fe,U.dash,U.cap,we,O,q,pe,j):It(v,ye,Fe,U.dash,U.cap,we,O,q,pe,Be,j),st&&f.translate(-ke,-ke)}function It(v,T,U,O,q,j,pe,ye,we,Fe,Be){let ke=!1;we!=0&&E.forEach((st,bt)=>{if(st.series[0]==v){let St=y[st.series[1]],pt=e[st.series[1]],je=(St._paths||Ba).band;Js(je)&&(je=st.dir==1?je[0]:je[1]);let $e,Ht=null;St.show&&je&&Cw(pt,rn,on)?(Ht=st.fill(i,bt)||j,$e=St._paths.clip):je=null,ze(T,U,O,q,Ht,pe,ye,we,Fe,Be,$e,je),ke=!0}}),ke||ze(T,U,O,q,j,pe,ye,we,Fe,Be)}let xn=bo|Uf;function ze(v,T,U,O,q,j,pe,ye,we,Fe,Be,ke){Re(v,T,U,O,q),(we||Fe||ke)&&(f.save(),we&&f.clip(we),Fe&&f.clip(Fe)),ke?(ye&xn)==xn?(f.clip(ke),Be&&f.clip(Be),gt(q,pe),ln(v,j,T)):ye&Uf?(gt(q,pe),f.clip(ke),ln(v,j,T)):ye&bo&&(f.save(),f.clip(ke),Be&&f.clip(Be),gt(q,pe),f.restore(),ln(v,j,T)):(gt(q,pe),ln(v,j,T)),(we||Fe||ke)&&f.restore()}function ln(v,T,U){U>0&&(T instanceof Map?T.forEach((O,q)=>{f.strokeStyle=Sr=q,f.stroke(O)}):T!=null&&v&&f.stroke(T))}function gt(v,T){T instanceof Map?T.forEach((U,O)=>{f.fillStyle=Ts=O,f.fill(U)}):T!=null&&v&&f.fill(T)}function ns(v,T,U,O){let q=P[v],j;if(O<=0)j=[0,0];else{let pe=q._space=q.space(i,v,T,U,O),ye=q._incrs=q.incrs(i,v,T,U,O,pe);j=ZE(T,U,ye,O,pe)}return q._found=j}function cn(v,T,U,O,q,j,pe,ye,we,Fe){let Be=pe%2/2;_==1&&f.translate(Be,Be),Re(ye,pe,we,Fe,ye),f.beginPath();let ke,st,bt,St,pt=q+(O==0||O==3?-j:j);U==0?(st=q,St=pt):(ke=q,bt=pt);for(let je=0;je<v.length;je++)T[je]!=null&&(U==0?ke=bt=v[je]:st=St=v[je],f.moveTo(ke,st),f.lineTo(bt,St));f.stroke(),_==1&&f.translate(-Be,-Be)}function br(v){let T=!0;return P.forEach((U,O)=>{if(!U.show)return;let q=S[U.scale];if(q.min==null){U._show&&(T=!1,U._show=!1,lt(!1));return}else U._show||(T=!1,U._show=!0,lt(!1));let j=U.side,pe=j%2,{min:ye,max:we}=q,[Fe,Be]=ns(O,ye,we,pe==0?V:Ie);if(Be==0)return;let ke=q.distr==2,st=U._splits=U.splits(i,O,ye,we,Fe,Be,ke),bt=q.distr==2?st.map($e=>ei[$e]):st,St=q.distr==2?ei[st[1]]-ei[st[0]]:Fe,pt=U._values=U.values(i,U.filter(i,bt,O,Be,St),O,Be,St);U._rotate=j==2?U.rotate(i,pt,O,Be):0;let je=U._size;U._size=yi(U.size(i,pt,O,v)),je!=null&&U._size!=je&&(T=!1)}),T}function Bi(v){let T=!0;return Co.forEach((U,O)=>{let q=U(i,O,Fi,v);q!=vi[O]&&(T=!1),vi[O]=q}),T}function is(){for(let v=0;v<P.length;v++){let T=P[v];if(!T.show||!T._show)continue;let U=T.side,O=U%2,q,j,pe=T.stroke(i,v),ye=U==0||U==3?-1:1,[we,Fe]=T._found;if(T.label!=null){let Xn=T.labelGap*ye,ii=Mn((T._lpos+Xn)*At);Ne(T.labelFont[0],pe,"center",U==2?"top":rg),f.save(),O==1?(q=j=0,f.translate(ii,Mn(w+xe/2)),f.rotate((U==3?-yh:yh)/2)):(q=Mn(L+$/2),j=ii);let er=$g(T.label)?T.label(i,v,we,Fe):T.label;f.fillText(er,q,j),f.restore()}if(Fe==0)continue;let Be=S[T.scale],ke=O==0?$:xe,st=O==0?L:w,bt=T._splits,St=Be.distr==2?bt.map(Xn=>ei[Xn]):bt,pt=Be.distr==2?ei[bt[1]]-ei[bt[0]]:we,je=T.ticks,$e=T.border,Ht=je.show?je.size:0,tn=Mn(Ht*At),An=Mn((T.alignTo==2?T._size-Ht-T.gap:T.gap)*At),Dt=T._rotate*-yh/180,nn=g(T._pos*At),ti=(tn+An)*ye,Wn=nn+ti;j=O==0?Wn:0,q=O==1?Wn:0;let ui=T.font[0],Si=T.align==1?_o:T.align==2?Sf:Dt>0?_o:Dt<0?Sf:O==0?"center":U==3?Sf:_o,Vi=Dt||O==1?"middle":U==2?"top":rg;Ne(ui,pe,Si,Vi);let ni=T.font[1]*T.lineGap,fi=bt.map(Xn=>g(a(Xn,Be,ke,st))),Mi=T._values;for(let Xn=0;Xn<Mi.length;Xn++){let ii=Mi[Xn];if(ii!=null){O==0?q=fi[Xn]:j=fi[Xn],ii=""+ii;let er=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let qn=0;qn<er.length;qn++){let xd=er[qn];Dt?(f.save(),f.translate(q,j+qn*ni),f.rotate(Dt),f.fillText(xd,0,0),f.restore()):f.fillText(xd,q,j+qn*ni)}}}je.show&&cn(fi,je.filter(i,St,v,Fe,pt),O,U,nn,tn,Bt(je.width*At,3),je.stroke(i,v),je.dash,je.cap);let Gi=T.grid;Gi.show&&cn(fi,Gi.filter(i,St,v,Fe,pt),O,O==0?2:1,O==0?w:L,O==0?xe:$,Bt(Gi.width*At,3),Gi.stroke(i,v),Gi.dash,Gi.cap),$e.show&&cn([nn],[1],O==0?1:0,O==0?1:2,O==1?w:L,O==1?xe:$,Bt($e.width*At,3),$e.stroke(i,v),$e.dash,$e.cap)}Tn("drawAxes")}function lt(v){y.forEach((T,U)=>{U>0&&(T._paths=null,v&&(s==1?(T.min=null,T.max=null):T.facets.forEach(O=>{O.min=null,O.max=null})))})}let en=!1,Hn=!1,Lt=[];function hn(){Hn=!1;for(let v=0;v<Lt.length;v++)Tn(...Lt[v]);Lt.length=0}function On(){en||(Gw(ed),en=!0)}function Va(v,T=!1){en=!0,Hn=T,v(i),ed(),T&&Lt.length>0&&queueMicrotask(hn)}i.batch=Va;function ed(){if(fe&&(ut(),fe=!1),be&&(Ae(),be=!1),Me){if(qt(p,_o,Ke),qt(p,"top",ot),qt(p,Na,V),qt(p,Ua,Ie),qt(m,_o,Ke),qt(m,"top",ot),qt(m,Na,V),qt(m,Ua,Ie),qt(h,Na,Nt),qt(h,Ua,jt),u.width=Mn(Nt*At),u.height=Mn(jt*At),P.forEach(({_el:v,_show:T,_size:U,_pos:O,side:q})=>{if(v!=null)if(T){let j=q===3||q===0?U:0,pe=q%2==1;qt(v,pe?"left":"top",O-j),qt(v,pe?"width":"height",U),qt(v,pe?"top":"left",pe?ot:Ke),qt(v,pe?"height":"width",pe?Ie:V),Pf(v,gr)}else li(v,gr)}),Sr=Ts=Mr=H=te=J=K=Ce=R=null,Le=1,Do(!0),Ke!=Te||ot!=Ut||V!=We||Ie!=Ze){lt(!1);let v=V/We,T=Ie/Ze;if(de&&!oe&&ie.left>=0){ie.left*=v,ie.top*=T,wr&&Qi(wr,Mn(ie.left),0,V,Ie),Er&&Qi(Er,0,Mn(ie.top),V,Ie);for(let U=0;U<at.length;U++){let O=at[U];O!=null&&(kt[U]*=v,Gn[U]*=T,Qi(O,yi(kt[U]),yi(Gn[U]),V,Ie))}}if(Gt.show&&!ce&&Gt.left>=0&&Gt.width>0){Gt.left*=v,Gt.width*=v,Gt.top*=T,Gt.height*=T;for(let U in Oh)qt(Cr,U,Gt[U])}Te=Ke,Ut=ot,We=V,Ze=Ie}Tn("setSize"),Me=!1}Nt>0&&jt>0&&(f.clearRect(0,0,u.width,u.height),Tn("drawClear"),M.forEach(v=>v()),Tn("draw")),Gt.show&&ce&&(Ga(Gt),ce=!1),de&&oe&&(Qs(null,!0,!1),oe=!1),Q.show&&Q.live&&ve&&(Uh(),ve=!1),l||(l=!0,i.status=1,Tn("ready")),Es=!1,en=!1}i.redraw=(v,T)=>{be=T||!1,v!==!1?Cs(b,C.min,C.max):On()};function Lh(v,T){let U=S[v];if(U.from==null){if(Qt==0){let O=U.range(i,T.min,T.max,v);T.min=O[0],T.max=O[1]}if(T.min>T.max){let O=T.min;T.min=T.max,T.max=O}if(Qt>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;v==b&&U.distr==2&&Qt>0&&(T.min=Di(T.min,e[0]),T.max=Di(T.max,e[0]),T.min==T.max&&T.max++),z[v]=T,fe=!0,On()}}i.setScale=Lh;let Dh,Nh,wr,Er,td,nd,Tr,Ar,id,sd,Vt,Yt,As=!1,Pn=ie.drag,wn=Pn.x,En=Pn.y;de&&(ie.x&&(Dh=xi(fw,m)),ie.y&&(Nh=xi(dw,m)),C.ori==0?(wr=Dh,Er=Nh):(wr=Nh,Er=Dh),Vt=ie.left,Yt=ie.top);let Gt=i.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Cr=Gt.show?xi(uw,Gt.over?m:p):null;function Ga(v,T){if(Gt.show){for(let U in v)Gt[U]=v[U],U in Oh&&qt(Cr,U,v[U]);T!==!1&&Tn("setSelect")}}i.setSelect=Ga;function U0(v){if(y[v].show)Z&&Pf(ne[v],gr);else if(Z&&li(ne[v],gr),de){let U=Pe?at[0]:at[v];U!=null&&Qi(U,-10,-10,V,Ie)}}function Cs(v,T,U){Lh(v,{min:T,max:U})}function zi(v,T,U,O){T.focus!=null&&k0(v),T.show!=null&&y.forEach((q,j)=>{j>0&&(v==j||v==null)&&(q.show=T.show,U0(j),s==2?(Cs(q.facets[0].scale,null,null),Cs(q.facets[1].scale,null,null)):Cs(q.scale,null,null),On())}),U!==!1&&Tn("setSeries",v,T),O&&No("setSeries",i,v,T)}i.setSeries=zi;function F0(v,T){_n(E[v],T)}function O0(v,T){v.fill=xt(v.fill||null),v.dir=Mt(v.dir,-1),T=T??E.length,E.splice(T,0,v)}function B0(v){v==null?E.length=0:E.splice(v,1)}i.addBand=O0,i.setBand=F0,i.delBand=B0;function z0(v,T){y[v].alpha=T,de&&at[v]!=null&&(at[v].style.opacity=T),Z&&ne[v]&&(ne[v].style.opacity=T)}let ss,Rs,js,Rr={focus:!0};function k0(v){if(v!=js){let T=v==null,U=Ve.alpha!=1;y.forEach((O,q)=>{if(s==1||q>0){let j=T||q==0||q==v;O._focus=T?null:j,U&&z0(q,j?1:Ve.alpha)}}),js=v,U&&On()}}Z&&tt&&mt(cg,ge,v=>{ie._lock||(et(v),js!=null&&zi(null,Rr,!0,un.setSeries))});function ki(v,T,U){let O=S[T];U&&(v=v/At-(O.ori==1?ot:Ke));let q=V;O.ori==1&&(q=Ie,v=q-v),O.dir==-1&&(v=q-v);let j=O._min,pe=O._max,ye=v/q,we=j+(pe-j)*ye,Fe=O.distr;return Fe==3?vo(10,we):Fe==4?Pw(we,O.asinh):Fe==100?O.bwd(we):we}function V0(v,T){let U=ki(v,b,T);return Di(U,e[0],rn,on)}i.valToIdx=v=>Di(v,e[0]),i.posToIdx=V0,i.posToVal=ki,i.valToPos=(v,T,U)=>S[T].ori==0?r(v,S[T],U?$:V,U?L:0):o(v,S[T],U?xe:Ie,U?w:0),i.setCursor=(v,T,U)=>{Vt=v.left,Yt=v.top,Qs(null,T,U)};function rd(v,T){qt(Cr,_o,Gt.left=v),qt(Cr,Na,Gt.width=T)}function od(v,T){qt(Cr,"top",Gt.top=v),qt(Cr,Ua,Gt.height=T)}let Io=C.ori==0?rd:od,Lo=C.ori==1?rd:od;function G0(){if(Z&&Q.live)for(let v=s==2?1:0;v<y.length;v++){if(v==0&&Oe)continue;let T=Q.values[v],U=0;for(let O in T)le[v][U++].firstChild.nodeValue=T[O]}}function Uh(v,T){if(v!=null&&(v.idxs?v.idxs.forEach((U,O)=>{re[O]=U}):Nw(v.idx)||re.fill(v.idx),Q.idx=re[0]),Z&&Q.live){for(let U=0;U<y.length;U++)(U>0||s==1&&!Oe)&&H0(U,re[U]);G0()}ve=!1,T!==!1&&Tn("setLegend")}i.setLegend=Uh;function H0(v,T){let U=y[v],O=v==0&&D==2?ei:e[v],q;Oe?q=U.values(i,v,T)??Xe:(q=U.value(i,T==null?null:O[T],v,T),q=q==null?Xe:{_:q}),Q.values[v]=q}function Qs(v,T,U){id=Vt,sd=Yt,[Vt,Yt]=ie.move(i,Vt,Yt),ie.left=Vt,ie.top=Yt,de&&(wr&&Qi(wr,Mn(Vt),0,V,Ie),Er&&Qi(Er,0,Mn(Yt),V,Ie));let O,q=rn>on;ss=Ot,Rs=null;let j=C.ori==0?V:Ie,pe=C.ori==1?V:Ie;if(Vt<0||Qt==0||q){O=ie.idx=null;for(let ye=0;ye<y.length;ye++){let we=at[ye];we!=null&&Qi(we,-10,-10,V,Ie)}tt&&zi(null,Rr,!0,v==null&&un.setSeries),Q.live&&(re.fill(O),ve=!0)}else{let ye,we,Fe;s==1&&(ye=C.ori==0?Vt:Yt,we=ki(ye,b),O=ie.idx=Di(we,e[0],rn,on),Fe=F(e[0][O],C,j,0));let Be=-10,ke=-10,st=0,bt=0,St=!0,pt="",je="";for(let $e=s==2?1:0;$e<y.length;$e++){let Ht=y[$e],tn=re[$e],An=tn==null?null:s==1?e[$e][tn]:e[$e][1][tn],Dt=ie.dataIdx(i,$e,O,we),nn=Dt==null?null:s==1?e[$e][Dt]:e[$e][1][Dt];if(ve=ve||nn!=An||Dt!=tn,re[$e]=Dt,$e>0&&Ht.show){let ti=Dt==null?-10:Dt==O?Fe:F(s==1?e[0][Dt]:e[$e][0][Dt],C,j,0),Wn=nn==null?-10:I(nn,s==1?S[Ht.scale]:S[Ht.facets[1].scale],pe,0);if(tt&&nn!=null){let ui=C.ori==1?Vt:Yt,Si=bn(Ve.dist(i,$e,Dt,Wn,ui));if(Si<ss){let Vi=Ve.bias;if(Vi!=0){let ni=ki(ui,Ht.scale),fi=nn>=0?1:-1,Mi=ni>=0?1:-1;Mi==fi&&(Mi==1?Vi==1?nn>=ni:nn<=ni:Vi==1?nn<=ni:nn>=ni)&&(ss=Si,Rs=$e)}else ss=Si,Rs=$e}}if(ve||Pe){let ui,Si;C.ori==0?(ui=ti,Si=Wn):(ui=Wn,Si=ti);let Vi,ni,fi,Mi,Gi,Xn,ii=!0,er=_e.bbox;if(er!=null){ii=!1;let qn=er(i,$e);fi=qn.left,Mi=qn.top,Vi=qn.width,ni=qn.height}else fi=ui,Mi=Si,Vi=ni=_e.size(i,$e);if(Xn=_e.fill(i,$e),Gi=_e.stroke(i,$e),Pe)$e==Rs&&ss<=Ve.prox&&(Be=fi,ke=Mi,st=Vi,bt=ni,St=ii,pt=Xn,je=Gi);else{let qn=at[$e];qn!=null&&(kt[$e]=fi,Gn[$e]=Mi,gg(qn,Vi,ni,ii),pg(qn,Xn,Gi),Qi(qn,yi(fi),yi(Mi),V,Ie))}}}}if(Pe){let $e=Ve.prox,Ht=js==null?ss<=$e:ss>$e||Rs!=js;if(ve||Ht){let tn=at[0];tn!=null&&(kt[0]=Be,Gn[0]=ke,gg(tn,st,bt,St),pg(tn,pt,je),Qi(tn,yi(Be),yi(ke),V,Ie))}}}if(Gt.show&&As)if(v!=null){let[ye,we]=un.scales,[Fe,Be]=un.match,[ke,st]=v.cursor.sync.scales,bt=v.cursor.drag;if(wn=bt._x,En=bt._y,wn||En){let{left:St,top:pt,width:je,height:$e}=v.select,Ht=v.scales[ke].ori,tn=v.posToVal,An,Dt,nn,ti,Wn,ui=ye!=null&&Fe(ye,ke),Si=we!=null&&Be(we,st);ui&&wn?(Ht==0?(An=St,Dt=je):(An=pt,Dt=$e),nn=S[ye],ti=F(tn(An,ke),nn,j,0),Wn=F(tn(An+Dt,ke),nn,j,0),Io(Ni(ti,Wn),bn(Wn-ti))):Io(0,j),Si&&En?(Ht==1?(An=St,Dt=je):(An=pt,Dt=$e),nn=S[we],ti=I(tn(An,st),nn,pe,0),Wn=I(tn(An+Dt,st),nn,pe,0),Lo(Ni(ti,Wn),bn(Wn-ti))):Lo(0,pe)}else Bh()}else{let ye=bn(id-td),we=bn(sd-nd);if(C.ori==1){let st=ye;ye=we,we=st}wn=Pn.x&&ye>=Pn.dist,En=Pn.y&&we>=Pn.dist;let Fe=Pn.uni;Fe!=null?wn&&En&&(wn=ye>=Fe,En=we>=Fe,!wn&&!En&&(we>ye?En=!0:wn=!0)):Pn.x&&Pn.y&&(wn||En)&&(wn=En=!0);let Be,ke;wn&&(C.ori==0?(Be=Tr,ke=Vt):(Be=Ar,ke=Yt),Io(Ni(Be,ke),bn(ke-Be)),En||Lo(0,pe)),En&&(C.ori==1?(Be=Tr,ke=Vt):(Be=Ar,ke=Yt),Lo(Ni(Be,ke),bn(ke-Be)),wn||Io(0,j)),!wn&&!En&&(Io(0,0),Lo(0,0))}if(Pn._x=wn,Pn._y=En,v==null){if(U){if(_d!=null){let[ye,we]=un.scales;un.values[0]=ye!=null?ki(C.ori==0?Vt:Yt,ye):null,un.values[1]=we!=null?ki(C.ori==1?Vt:Yt,we):null}No(Mf,i,Vt,Yt,V,Ie,O)}if(tt){let ye=U&&un.setSeries,we=Ve.prox;js==null?ss<=we&&zi(Rs,Rr,!0,ye):ss>we?zi(null,Rr,!0,ye):Rs!=js&&zi(Rs,Rr,!0,ye)}}ve&&(Q.idx=O,Uh()),T!==!1&&Tn("setCursor")}let Ps=null;Object.defineProperty(i,"rect",{get(){return Ps==null&&Do(!1),Ps}});function Do(v=!1){v?Ps=null:(Ps=m.getBoundingClientRect(),Tn("syncRect",Ps))}function ad(v,T,U,O,q,j,pe){ie._lock||As&&v!=null&&v.movementX==0&&v.movementY==0||(Fh(v,T,U,O,q,j,pe,!1,v!=null),v!=null?Qs(null,!0,!0):Qs(T,!0,!1))}function Fh(v,T,U,O,q,j,pe,ye,we){if(Ps==null&&Do(!1),et(v),v!=null)U=v.clientX-Ps.left,O=v.clientY-Ps.top;else{if(U<0||O<0){Vt=-10,Yt=-10;return}let[Fe,Be]=un.scales,ke=T.cursor.sync,[st,bt]=ke.values,[St,pt]=ke.scales,[je,$e]=un.match,Ht=T.axes[0].side%2==1,tn=C.ori==0?V:Ie,An=C.ori==1?V:Ie,Dt=Ht?j:q,nn=Ht?q:j,ti=Ht?O:U,Wn=Ht?U:O;if(St!=null?U=je(Fe,St)?a(st,S[Fe],tn,0):-10:U=tn*(ti/Dt),pt!=null?O=$e(Be,pt)?a(bt,S[Be],An,0):-10:O=An*(Wn/nn),C.ori==1){let ui=U;U=O,O=ui}}we&&(T==null||T.cursor.event.type==Mf)&&((U<=1||U>=V-1)&&(U=pr(U,V)),(O<=1||O>=Ie-1)&&(O=pr(O,Ie))),ye?(td=U,nd=O,[Tr,Ar]=ie.move(i,U,O)):(Vt=U,Yt=O)}let Oh={width:0,height:0,left:0,top:0};function Bh(){Ga(Oh,!1)}let ld,cd,hd,ud;function fd(v,T,U,O,q,j,pe){As=!0,wn=En=Pn._x=Pn._y=!1,Fh(v,T,U,O,q,j,pe,!0,!1),v!=null&&(mt(bf,Cf,dd,!1),No(ag,i,Tr,Ar,V,Ie,null));let{left:ye,top:we,width:Fe,height:Be}=Gt;ld=ye,cd=we,hd=Fe,ud=Be}function dd(v,T,U,O,q,j,pe){As=Pn._x=Pn._y=!1,Fh(v,T,U,O,q,j,pe,!1,!0);let{left:ye,top:we,width:Fe,height:Be}=Gt,ke=Fe>0||Be>0,st=ld!=ye||cd!=we||hd!=Fe||ud!=Be;if(ke&&st&&Ga(Gt),Pn.setScale&&ke&&st){let bt=ye,St=Fe,pt=we,je=Be;if(C.ori==1&&(bt=we,St=Be,pt=ye,je=Fe),wn&&Cs(b,ki(bt,b),ki(bt+St,b)),En)for(let $e in S){let Ht=S[$e];$e!=b&&Ht.from==null&&Ht.min!=Ot&&Cs($e,ki(pt+je,$e),ki(pt,$e))}Bh()}else ie.lock&&(ie._lock=!ie._lock,Qs(T,!0,v!=null));v!=null&&(sn(bf,Cf),No(bf,i,Vt,Yt,V,Ie,null))}function W0(v,T,U,O,q,j,pe){if(ie._lock)return;et(v);let ye=As;if(As){let we=!0,Fe=!0,Be=10,ke,st;C.ori==0?(ke=wn,st=En):(ke=En,st=wn),ke&&st&&(we=Vt<=Be||Vt>=V-Be,Fe=Yt<=Be||Yt>=Ie-Be),ke&&we&&(Vt=Vt<Tr?0:V),st&&Fe&&(Yt=Yt<Ar?0:Ie),Qs(null,!0,!0),As=!1}Vt=-10,Yt=-10,re.fill(null),Qs(null,!0,!0),ye&&(As=ye)}function pd(v,T,U,O,q,j,pe){ie._lock||(et(v),Po(),Bh(),v!=null&&No(hg,i,Vt,Yt,V,Ie,null))}function md(){P.forEach(JE),k(i.width,i.height,!0)}_r(vh,yo,md);let Pr={};Pr.mousedown=fd,Pr.mousemove=ad,Pr.mouseup=dd,Pr.dblclick=pd,Pr.setSeries=(v,T,U,O)=>{let q=un.match[2];U=q(i,T,U),U!=-1&&zi(U,O,!0,!1)},de&&(mt(ag,m,fd),mt(Mf,m,ad),mt(lg,m,v=>{et(v),Do(!1)}),mt(cg,m,W0),mt(hg,m,pd),Ff.add(i),i.syncRect=Do);let Ha=i.hooks=n.hooks||{};function Tn(v,T,U){Hn?Lt.push([v,T,U]):v in Ha&&Ha[v].forEach(O=>{O.call(null,i,T,U)})}(n.plugins||[]).forEach(v=>{for(let T in v.hooks)Ha[T]=(Ha[T]||[]).concat(v.hooks[T])});let gd=(v,T,U)=>U,un=_n({key:null,setSeries:!1,filters:{pub:Sg,sub:Sg},scales:[b,y[1]?y[1].scale:null],match:[Mg,Mg,gd],values:[null,null]},ie.sync);un.match.length==2&&un.match.push(gd),ie.sync=un;let _d=un.key,zh=x0(_d);function No(v,T,U,O,q,j,pe){un.filters.pub(v,T,U,O,q,j,pe)&&zh.pub(v,T,U,O,q,j,pe)}zh.sub(i);function X0(v,T,U,O,q,j,pe){un.filters.sub(v,T,U,O,q,j,pe)&&Pr[v](null,T,U,O,q,j,pe)}i.pub=X0;function q0(){zh.unsub(i),Ff.delete(i),Kt.clear(),If(vh,yo,md),c.remove(),ge?.remove(),Tn("destroy")}i.destroy=q0;function kh(){Tn("init",n,e),Ro(e||n.data,!1),z[b]?Lh(b,z[b]):Po(),ce=Gt.show&&(Gt.width>0||Gt.height>0),oe=ve=!0,k(n.width,n.height)}return y.forEach(vr),P.forEach(es),t?t instanceof HTMLElement?(t.appendChild(c),kh()):t(i,kh):kh(),i}Fn.assign=_n;Fn.fmtNum=Hf;Fn.rangeNum=Sh;Fn.rangeLog=wh;Fn.rangeAsinh=Vf;Fn.orient=yr;Fn.pxRatio=At;Fn.join=Vw;Fn.fmtDate=Xf,Fn.tzDate=jw;Fn.sync=x0;{Fn.addGap=NE,Fn.clipGaps=Ah;let n=Fn.paths={points:w0};n.linear=T0,n.stepped=OE,n.bars=BE,n.spline=kE}var jf=30,KE=200,Ui=16384,P0=["#b3261e","#2e7d32","#1652b8","#e07a5f","#66a182","#7aa5e8","#7a1811","#14532d","#0b2e6b","#444","#888","#d81b9a"];function I0(n){let e=Array.from({length:n+1},()=>new Float64Array(Ui)),[t,i]=[0,0];function s(o,a){let l=e[0][(i+Ui-1)%Ui];t&&(o<l||o-l>jf)&&(t=0),e[0][i]=o;for(let c=0;c<n;c++)e[c+1][i]=a[c];i=(i+1)%Ui,t=Math.min(t+1,Ui)}function r(o){if(!t)return[[],...o.map(()=>[])];let a=e[0][(i+Ui-1)%Ui],l=0;for(;l<t&&a-e[0][(i+Ui-1-l)%Ui]<=jf;)l+=1;let c=i-l+Ui,u=(h,p)=>Array.from({length:l},(m,_)=>p(h[(c+_)%Ui])),f=h=>Number.isNaN(h)?null:h;return[u(e[0],h=>h-a),...o.map(h=>u(e[h+1],f))]}return{push:s,last:r}}function L0(n,e,t){let i={font:"11px system-ui",size:34,stroke:"#555",grid:{stroke:"#e8e8e2"}},s=e.map((a,l)=>({label:a,stroke:P0[l%P0.length],width:1,points:{show:!1}})),r={width:n.clientWidth||420,height:t,cursor:{show:!1},scales:{x:{time:!1,range:[-jf,0]}},axes:[i,{...i,size:48}],series:[{label:"s"},...s]},o=new Fn(r,[[],...e.map(()=>[])],n);return new ResizeObserver(()=>o.setSize({width:n.clientWidth,height:t})).observe(n),o}function D0(n,e,t){let i=I0(e.length),s=I0(t.length),r=L0(n("forces"),t.map(h=>`face ${h}`),130);n("face").append(...t.map(h=>new Option(h,h)));let o,a;function l(){let h=n("face").value;o=e.flatMap((p,m)=>p.startsWith(`F${h}-`)?[m]:[]),a?.destroy(),n("channels").replaceChildren(),a=L0(n("channels"),o.map(p=>e[p].slice(3)),170)}n("face").addEventListener("change",l),l();function c({rows:h,wide:p,values:m,timeS:_,contacts:g}){for(let d=0;d<h;d++){let y=d*p;i.push(_+m[y],m.subarray(y+1,y+p))}s.push(_,t.map(d=>g.reduce((y,P)=>P.face===d?y+P.force:y,0)))}let u=0;function f(h){h-u<KE||(u=h,a.setData(i.last(o)),r.setData(s.last(t.map((p,m)=>m))))}return{take:c,draw:f}}var Qf=["good","absent","silent","saturated","dead","noisy","drifting"],jE=1e3,QE=100;async function e1(){let n=E=>document.querySelector(`[data-name="${E}"]`),e=await fetch(`/scene${location.search}`);if(!e.ok)throw new Error(`the server refused the scene (${e.status})`);let t=await tr(new Uint8Array(await e.arrayBuffer())),{content:i}=t,{channels:s}=i.live;n("name").textContent=`${i.name}, live`,document.title=`${i.name}, live`,n("key").textContent=i.live.key;let r=Ys(n("canvas"),i.size_mm),o=oh(t,r);r.scene.add(o.root);let a=tg(r,n("overlay"),o.silicone.front.geometry),l=i.faces.map(E=>E.number),c=D0(n,s,l),u=s1(n("health"),s);o.fade(Number(n("opacity").value)/100),n("opacity").addEventListener("input",()=>o.fade(Number(n("opacity").value)/100));let f=ng(),h,p,m,_={},g=0;function d(E){if(requestAnimationFrame(d),m&&f.seen(m),m=null,!p)return;let b=performance.now();a.show(p.contacts,p.labels),E-g>=QE&&(i1(n("contacts"),p.contacts),g=E),c.draw(E),h.readyState===WebSocket.OPEN&&h.send(Uint32Array.of(p.number)),[m,p]=[p,null],f.drawn(performance.now()-b)}function y({data:E}){let b=ig(E,s.length);if(b.state)return P(_=b.state);f.came(b),c.take(b),p=b}function P(E){u.show(E.health??[]);let{recording:b}=E;n("record").setAttribute("aria-pressed",String(!!b?.on)),n("record").textContent=b?.on?"recording":"record",n("record").title=b?.file?`into ${b.file}`:"",n("zero").textContent=E.zeroed?"zero":"zeroing \u2026";let x=[E.told,E.trouble,E.explained===!1?"no contact that the model knows explains these readings":""].filter(Boolean).join("; ");n("trouble").textContent!==x&&(n("trouble").textContent=x),n("told").textContent=n1(E,f.told())}function S(){h=new WebSocket(`ws://${location.host}/stream${location.search}`),h.binaryType="arraybuffer",h.onmessage=y,h.onclose=()=>{n("told").textContent="the server does not answer; what was recorded is kept",setTimeout(S,jE)}}n("zero").addEventListener("click",()=>h.send("zero")),n("record").addEventListener("click",()=>h.send(_.recording?.on?"record off":"record on")),requestAnimationFrame(d),S(),window.instobjLive={figures:()=>({...f.told(),objectDrawn:r.drawn()}),forget:f.forget,state:()=>_,contacts:a.shown,labels:a.told,hidden:a.hidden,pictureMs:()=>t1(r)},document.getElementById("instobj-live").dataset.ready="yes"}function t1(n){let e=n.renderer.getContext(),t=performance.now();return n.draw(),e.readPixels(0,0,1,1,e.RGBA,e.UNSIGNED_BYTE,new Uint8Array(4)),performance.now()-t}function n1(n,e){let{recording:t,counted:i}=n,s=[n.source,`${ws(n.rate_hz,0)} frames/s`];return i&&s.push(`${i.lost} lost, ${i.damaged} damaged lines, ${i.restarts} restarts`),t&&s.push(t.on||t.rows?`${t.rows} rows in ${t.file}${t.unlabelled?`, ${t.unlabelled} frames without a force not written`:""}`:"not recording"),s.push(`${ws(e.perSecond,0)} pictures/s, ${ws(e.latencyMs.p50,0)} ms old (99 %: ${ws(e.latencyMs.p99,0)})`),e.dropped&&s.push(`${e.dropped} frames not shown here`),s.filter(Boolean).join(" \xB7 ")}var ws=(n,e)=>Number.isFinite(n)?n.toFixed(e):"\u2013";function i1(n,e){n.replaceChildren(...e.map(t=>{let i=document.createElement("tr");return[t.face,ws(t.x,1),ws(t.y,1),ws(t.radius,1),`${ws(t.force,2)} \xB1 ${ws(t.halfwidth,2)}`].forEach(r=>i.insertCell().append(String(r).replace("-","\u2212"))),i}))}function s1(n,e){let t=[];for(let s=0;s<e.length;s+=3){let[,r,o]=e[s].match(/^F(\d)-X(\d+)$/),a=n.insertRow();a.insertCell().append(r),a.insertCell().append(o);for(let l=0;l<3;l++)t.push(a.insertCell())}function i(s){s.forEach((r,o)=>{t[o].className!==Qf[r]&&(t[o].className=Qf[r],t[o].textContent=Qf[r])})}return{show:i}}document.getElementById("instobj-live")&&e1().catch(n=>{document.querySelector('[data-name="trouble"]').textContent=`No live view: ${n.message}.`,console.warn(n)});var r1="instobj objects shown",o1={object:zm,layouts:Im};async function N0(n,e){try{return o1[n.dataset.kind](n,await tr(e))}catch(t){return n.hidden=!0,n.parentElement.querySelector(".no-viewer").textContent=`No view in three dimensions: ${t.message}.`,console.warn(t),null}}async function a1(){let n=[...document.querySelectorAll(".viewer[data-scene]")],e=s=>Wa(document.getElementById(s.dataset.scene).textContent),i=(await Promise.all(n.map(s=>N0(s,e(s))))).filter(s=>s?.press);i.length>1&&Nm(i),n.forEach(s=>!s.hidden&&(s.dataset.ready="yes")),requestAnimationFrame(()=>requestAnimationFrame(()=>performance.mark(r1)))}async function l1({model:n,el:e}){e.innerHTML=n.get("markup");let t=n.get("scene"),i=new Uint8Array(t.buffer,t.byteOffset,t.byteLength),s=await N0(e.querySelector(".viewer"),i);s&&(s.host.dataset.ready="yes")}document.querySelector(".viewer[data-scene]")&&requestAnimationFrame(()=>setTimeout(a1));return j0(c1);})();
